#pragma once
#include <span>
#include <vector>

#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

struct RefinedPose {
  PlanarPose planar;                    ///< in the aligned frames
  RigidTransform candidate_from_query;  ///< in the scenes' own frames
};

/// From one-to-one tree pairs: robust yaw, x and y; then, with these fixed, height, roll and pitch from base heights and
/// stem axes together, with a prior that axis alignment already left the scenes upright and, where a carried sensor stood in
/// both, that its height above the ground was the same.
RefinedPose refine_pose(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs, const PlanarPose& start,
                        const RefinePoseSettings& settings);

/// What the base heights of each pair count, the surest pair's 1: those of trees that few partial observations saw hang in the
/// air or lie in the ground.
std::vector<double> height_weights(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                   const RefinePoseSettings& settings);

}  // namespace stemwise::treeloc
