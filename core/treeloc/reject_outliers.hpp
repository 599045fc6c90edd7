#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {

/// Which triangle matches count (method.md, section 6).
struct RejectOutliersSettings {
  bool dbh_filter = true;
  double tau_dbh_m = 0.2;
  bool yaw_voting = true;
  double yaw_bin_deg = 5.0;
  double tau_yaw_deg = 10.0;
  Fields fields(const std::string& prefix);
};

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
