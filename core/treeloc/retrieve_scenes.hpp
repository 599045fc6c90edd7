#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/pairwise_distance_histogram.hpp"
#include "core/treeloc/step_settings.hpp"
#include "core/treeloc/tree_distribution_histogram.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {

/// What the published method stores of a scene.
struct PublishedDescriptor {
  std::vector<float> tdh, pdh;
  std::vector<Triangle> triangles;  ///< in order of key
};
PublishedDescriptor describe_published(const Scene& scene, const TdhSettings& tdh, const PdhSettings& pdh, TriangleMaker& maker);

/// sum of (a - b)^2 / (a + b).
double chi_square(std::span<const float> a, std::span<const float> b);
/// Shared keys, counted by the smaller number (eq. 4) or, not `multiset`, once each.
int shared_triangles(std::span<const Triangle> query, std::span<const Triangle> candidate, bool multiset);

struct RetrievedScene {
  std::uint32_t scene = 0;
  int shared = 0;
};
/// The scenes below `scene_limit` with the most shared triangles among those nearest by histograms, best first.
std::vector<RetrievedScene> retrieve_scenes(const PublishedDescriptor& query, std::span<const PublishedDescriptor> database,
                                            std::uint32_t scene_limit, bool use_tdh, bool use_pdh,
                                            const RetrieveSettings& settings);

}  // namespace stemwise::treeloc
