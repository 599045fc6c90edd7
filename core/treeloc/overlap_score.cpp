#include "core/treeloc/overlap_score.hpp"

#include <cmath>

namespace stemwise::treeloc {

Fields OverlapScoreSettings::fields(const std::string& prefix) {
  return {{prefix + ".penalty", "", "Candidates farther away score less", &penalty},
          {prefix + ".sigma_t_m", "m", "Scale of the spatial penalty", &sigma_t_m}};
}

double overlap_score(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                     const OverlapScoreSettings& settings) {
  const double either = static_cast<double>(query_trees + candidate_trees) - pairs;
  if (either <= 0.0) return 0.0;
  const double penalty =
      settings.penalty ? std::exp(-displacement_m * displacement_m / (settings.sigma_t_m * settings.sigma_t_m)) : 1.0;
  return pairs / either * penalty;
}

}  // namespace stemwise::treeloc
