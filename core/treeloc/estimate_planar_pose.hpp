#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/planar_pose.hpp"
#include "core/treeloc/reject_outliers.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// Least squares on the triangles' centroids (eq. 8), then reweighted least squares with a Huber kernel over the matched
/// vertices (eq. 9). Fewer than three triangles: over the vertices at once.
PlanarPose estimate_planar_pose(std::span<const TriangleMatch> inliers, std::span<const Triangle> query,
                                std::span<const Triangle> candidate, const Scene& query_scene, const Scene& candidate_scene,
                                const EstimatePlanarPoseSettings& settings);

}  // namespace stemwise::treeloc
