#include "core/treeloc/pairwise_distance_histogram.hpp"

namespace stemwise::treeloc {

Fields PdhSettings::fields(const std::string& prefix) {
  return {{prefix + ".enabled", "", "Use the pairwise distance histogram in retrieval", &enabled},
          {prefix + ".longest_m", "m", "Longest distance that is counted", &longest_m},
          {prefix + ".bins", "", "Bins", &bins}};
}

std::vector<float> pairwise_distance_histogram(const Scene& scene, const PdhSettings& settings) {
  std::vector<float> h(static_cast<std::size_t>(settings.bins), 0.0F);
  const double per_m = settings.bins / settings.longest_m;
  for (std::size_t i = 0; i < scene.trees.size(); ++i) {
    if (!scene.trees[i].reconstructed) continue;
    for (std::size_t j = i + 1; j < scene.trees.size(); ++j) {
      if (!scene.trees[j].reconstructed) continue;
      const double distance_m = (scene.trees[i].position_m - scene.trees[j].position_m).head<2>().norm();
      if (distance_m < settings.longest_m) h[static_cast<std::size_t>(distance_m * per_m)] += 1.0F;
    }
  }
  return h;
}

}  // namespace stemwise::treeloc
