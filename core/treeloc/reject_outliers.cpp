#include "core/treeloc/reject_outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/treeloc/assignment.hpp"
#include "core/treeloc/planar_pose.hpp"

namespace stemwise::treeloc {
namespace {

double dbh_difference(const SceneTree& a, const SceneTree& b) { return std::abs(a.dbh_m - b.dbh_m); }

/// Sum and largest of the three vertices' DBH differences.
struct DbhCost {
  double sum = 0.0;
  double largest = 0.0;
};
DbhCost dbh_cost(const Triangle& q, const Triangle& c, const Scene& query, const Scene& candidate) {
  DbhCost cost;
  for (int v = 0; v < 3; ++v) {
    const double d = dbh_difference(query.trees[q.tree[v]], candidate.trees[c.tree[v]]);
    cost.sum += d;
    cost.largest = std::max(cost.largest, d);
  }
  return cost;
}

std::array<Eigen::Vector2d, 3> corners(const Triangle& t, const Scene& scene) {
  return {scene.trees[t.tree[0]].position_m.head<2>(), scene.trees[t.tree[1]].position_m.head<2>(),
          scene.trees[t.tree[2]].position_m.head<2>()};
}

double handedness(const std::array<Eigen::Vector2d, 3>& p) {
  const Eigen::Vector2d a = p[1] - p[0], b = p[2] - p[0];
  return a.x() * b.y() - a.y() * b.x();
}

std::size_t end_of_key(std::span<const Triangle> list, std::size_t from) {
  std::size_t to = from;
  while (to < list.size() && list[to].key == list[from].key) ++to;
  return to;
}

/// Matches between the triangles [q0, q1) and [c0, c1), which all share one key.
void match_one_key(std::span<const Triangle> q, std::size_t q0, std::span<const Triangle> c, std::size_t c0, const Scene& query,
                   const Scene& candidate, const RejectOutliersSettings& settings, std::vector<TriangleMatch>& matches) {
  if (!settings.dbh_filter) {
    for (std::size_t i = 0; i < std::min(q.size(), c.size()); ++i) {
      matches.push_back({static_cast<std::uint32_t>(q0 + i), static_cast<std::uint32_t>(c0 + i)});
    }
    return;
  }
  constexpr double never = 1e3;  // metres: more than any sum of differences
  std::vector<double> cost;
  for (const Triangle& a : q) {
    for (const Triangle& b : c) {
      const DbhCost d = dbh_cost(a, b, query, candidate);
      cost.push_back(d.largest < settings.tau_dbh_m ? d.sum : never);
    }
  }
  const auto column_of = least_cost_assignment(cost, static_cast<int>(q.size()), static_cast<int>(c.size()));
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (column_of[i] < 0 || cost[i * c.size() + static_cast<std::size_t>(column_of[i])] >= never) continue;
    matches.push_back(
        {static_cast<std::uint32_t>(q0 + i), static_cast<std::uint32_t>(c0 + static_cast<std::size_t>(column_of[i]))});
  }
}

}  // namespace

Fields RejectOutliersSettings::fields(const std::string& prefix) {
  return {{prefix + ".dbh_filter", "", "Tell triangles of one key apart by the diameters of their trees", &dbh_filter},
          {prefix + ".tau_dbh_m", "m", "Diameters of corresponding vertices differ by less than this", &tau_dbh_m},
          {prefix + ".yaw_voting", "", "Keep only matches that agree with the dominant yaw", &yaw_voting},
          {prefix + ".yaw_bin_deg", "deg", "Bin of the yaw histogram", &yaw_bin_deg},
          {prefix + ".tau_yaw_deg", "deg", "Matches farther than this from the dominant yaw are outliers", &tau_yaw_deg}};
}

std::vector<TriangleMatch> match_triangles(std::span<const Triangle> query, std::span<const Triangle> candidate,
                                           const Scene& query_scene, const Scene& candidate_scene,
                                           const RejectOutliersSettings& settings) {
  std::vector<TriangleMatch> matches;
  std::size_t q = 0, c = 0;
  while (q < query.size() && c < candidate.size()) {
    if (query[q].key != candidate[c].key) {
      (query[q].key < candidate[c].key ? q : c)++;
      continue;
    }
    const std::size_t q1 = end_of_key(query, q), c1 = end_of_key(candidate, c);
    match_one_key(query.subspan(q, q1 - q), q, candidate.subspan(c, c1 - c), c, query_scene, candidate_scene, settings, matches);
    q = q1;
    c = c1;
  }
  return matches;
}

std::vector<TriangleMatch> vote_yaw(std::span<const TriangleMatch> matches, std::span<const Triangle> query,
                                    std::span<const Triangle> candidate, const Scene& query_scene, const Scene& candidate_scene,
                                    const RejectOutliersSettings& settings) {
  std::vector<TriangleMatch> kept;
  std::vector<double> yaw_deg;
  for (const TriangleMatch& m : matches) {
    const auto q = corners(query[m.query], query_scene), c = corners(candidate[m.candidate], candidate_scene);
    if ((handedness(q) > 0.0) != (handedness(c) > 0.0)) continue;  // det(R) < 0
    const std::array<PlanarPair, 3> pairs{{{q[0], c[0], 1.0}, {q[1], c[1], 1.0}, {q[2], c[2], 1.0}}};
    kept.push_back(m);
    yaw_deg.push_back(degrees(fit_planar_pose(pairs).yaw_rad()));
  }
  if (!settings.yaw_voting || kept.empty()) return kept;
  const auto bins = static_cast<std::size_t>(std::lround(360.0 / settings.yaw_bin_deg));
  std::vector<int> histogram(bins, 0);
  for (const double yaw : yaw_deg) ++histogram[static_cast<std::size_t>((yaw + 180.0) / settings.yaw_bin_deg) % bins];
  const auto peak = static_cast<double>(std::max_element(histogram.begin(), histogram.end()) - histogram.begin());
  const double dominant_deg = (peak + 0.5) * settings.yaw_bin_deg - 180.0;
  std::vector<TriangleMatch> inliers;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (std::abs(degrees(wrap_angle(radians(yaw_deg[i] - dominant_deg)))) < settings.tau_yaw_deg) inliers.push_back(kept[i]);
  }
  return inliers;
}

}  // namespace stemwise::treeloc
