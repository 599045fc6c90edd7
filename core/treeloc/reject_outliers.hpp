#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {

/// A triangle of the query and one of the candidate, by place in their lists.
struct TriangleMatch {
  std::uint32_t query = 0;
  std::uint32_t candidate = 0;
};

/// Within each shared key one-to-one matches of least total DBH difference (eq. 5), every vertex within tau_dbh (eq. 6);
/// without the DBH filter, in order of the lists. Both lists are in order of key.
std::vector<TriangleMatch> match_triangles(std::span<const Triangle> query, std::span<const Triangle> candidate,
                                           const Scene& query_scene, const Scene& candidate_scene,
                                           const RejectOutliersSettings& settings);

/// Drops reflections and, by a histogram of the turn each match implies, those that disagree with the dominant yaw (eq. 7).
std::vector<TriangleMatch> vote_yaw(std::span<const TriangleMatch> matches, std::span<const Triangle> query,
                                    std::span<const Triangle> candidate, const Scene& query_scene, const Scene& candidate_scene,
                                    const RejectOutliersSettings& settings);

}  // namespace stemwise::treeloc
