#include "core/treeloc/retrieve_scenes.hpp"

#include <algorithm>

namespace stemwise::treeloc {
namespace {

/// To 0..1 over the candidates; all the same: 0.
void normalise(std::vector<double>& distances) {
  const auto [low, high] = std::minmax_element(distances.begin(), distances.end());
  const double least = *low, range = *high - *low;
  for (double& d : distances) d = range > 0.0 ? (d - least) / range : 0.0;
}

/// The candidates of least summed distance.
std::vector<std::uint32_t> nearest_by_histograms(const PublishedDescriptor& query, std::span<const PublishedDescriptor> database,
                                                 bool use_tdh, bool use_pdh, const RetrieveSettings& settings) {
  std::vector<double> tdh(database.size(), 0.0), pdh(database.size(), 0.0);
  for (std::size_t s = 0; s < database.size(); ++s) {
    if (use_tdh) tdh[s] = chi_square(query.tdh, database[s].tdh);
    if (use_pdh) pdh[s] = chi_square(query.pdh, database[s].pdh);
  }
  normalise(tdh);
  normalise(pdh);
  std::vector<std::uint32_t> order(database.size());
  for (std::uint32_t s = 0; s < order.size(); ++s) order[s] = s;
  if (!settings.histograms || (!use_tdh && !use_pdh)) return order;
  const std::size_t kept = std::min(order.size(), static_cast<std::size_t>(settings.kept_by_histograms));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                    [&](std::uint32_t a, std::uint32_t b) {
                      const double da = tdh[a] + pdh[a], db = tdh[b] + pdh[b];
                      return da != db ? da < db : a < b;
                    });
  order.resize(kept);
  return order;
}

}  // namespace

Fields RetrieveSettings::fields(const std::string& prefix) {
  return {{prefix + ".histograms", "", "Prefilter the database by histograms", &histograms},
          {prefix + ".kept_by_histograms", "", "Scenes that the histograms keep", &kept_by_histograms},
          {prefix + ".verified", "", "Scenes with the most shared triangles that are verified", &verified},
          {prefix + ".multiset", "", "Count repeated triangles (eq. 4), not only whether they are there", &multiset}};
}

PublishedDescriptor describe_published(const Scene& scene, const TdhSettings& tdh, const PdhSettings& pdh, TriangleMaker& maker) {
  PublishedDescriptor d{tree_distribution_histogram(scene, tdh), pairwise_distance_histogram(scene, pdh), maker.make(scene)};
  std::stable_sort(d.triangles.begin(), d.triangles.end(), [](const Triangle& a, const Triangle& b) { return a.key < b.key; });
  return d;
}

double chi_square(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double total = a[i] + b[i], difference = a[i] - b[i];
    if (total > 0.0) sum += difference * difference / total;
  }
  return sum;
}

int shared_triangles(std::span<const Triangle> query, std::span<const Triangle> candidate, bool multiset) {
  int shared = 0;
  std::size_t q = 0, c = 0;
  while (q < query.size() && c < candidate.size()) {
    const std::uint32_t key = query[q].key;
    if (key != candidate[c].key) {
      (key < candidate[c].key ? q : c)++;
      continue;
    }
    ++shared, ++q, ++c;
    if (multiset) continue;
    while (q < query.size() && query[q].key == key) ++q;
    while (c < candidate.size() && candidate[c].key == key) ++c;
  }
  return shared;
}

std::vector<RetrievedScene> retrieve_scenes(const PublishedDescriptor& query, std::span<const PublishedDescriptor> database,
                                            std::uint32_t scene_limit, bool use_tdh, bool use_pdh,
                                            const RetrieveSettings& settings) {
  const auto allowed = database.first(std::min<std::size_t>(database.size(), scene_limit));
  if (allowed.empty()) return {};
  std::vector<RetrievedScene> found;
  for (const std::uint32_t s : nearest_by_histograms(query, allowed, use_tdh, use_pdh, settings)) {
    found.push_back({s, shared_triangles(query.triangles, allowed[s].triangles, settings.multiset)});
  }
  std::sort(found.begin(), found.end(), [](const RetrievedScene& a, const RetrievedScene& b) {
    return a.shared != b.shared ? a.shared > b.shared : a.scene < b.scene;
  });
  found.resize(std::min(found.size(), static_cast<std::size_t>(settings.verified)));
  return found;
}

}  // namespace stemwise::treeloc
