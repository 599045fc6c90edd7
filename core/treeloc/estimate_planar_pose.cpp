#include "core/treeloc/estimate_planar_pose.hpp"

#include <algorithm>

namespace stemwise::treeloc {
namespace {

Eigen::Vector2d corner(const Triangle& t, int v, const Scene& scene) { return scene.trees[t.tree[v]].position_m.head<2>(); }

Eigen::Vector2d centroid(const Triangle& t, const Scene& scene) {
  return (corner(t, 0, scene) + corner(t, 1, scene) + corner(t, 2, scene)) / 3.0;
}

}  // namespace

Fields EstimatePlanarPoseSettings::fields(const std::string& prefix) {
  return {{prefix + ".irls", "", "Reweighted least squares over the matched vertices", &irls},
          {prefix + ".huber_m", "m", "Residual from which on the Huber kernel weighs less", &huber_m},
          {prefix + ".iterations", "", "Reweighted steps", &iterations}};
}

PlanarPose estimate_planar_pose(std::span<const TriangleMatch> inliers, std::span<const Triangle> query,
                                std::span<const Triangle> candidate, const Scene& query_scene, const Scene& candidate_scene,
                                const EstimatePlanarPoseSettings& settings) {
  std::vector<PlanarPair> centroids, vertices;
  for (const TriangleMatch& m : inliers) {
    centroids.push_back({centroid(query[m.query], query_scene), centroid(candidate[m.candidate], candidate_scene), 1.0});
    for (int v = 0; v < 3; ++v)
      vertices.push_back({corner(query[m.query], v, query_scene), corner(candidate[m.candidate], v, candidate_scene), 1.0});
  }
  PlanarPose pose = fit_planar_pose(inliers.size() < 3 ? vertices : centroids);
  if (!settings.irls) return pose;
  for (int i = 0; i < settings.iterations; ++i) {
    for (PlanarPair& p : vertices) {
      const double residual_m = (pose * p.query - p.candidate).norm();
      p.weight = residual_m > settings.huber_m ? settings.huber_m / residual_m : 1.0;
    }
    pose = fit_planar_pose(vertices);
  }
  return pose;
}

}  // namespace stemwise::treeloc
