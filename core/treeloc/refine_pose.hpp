#pragma once
#include <span>

#include "core/base/field.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/scene.hpp"

namespace stemwise::treeloc {

/// The pose of a verified candidate in all six degrees of freedom (method.md, section 12, "Poses").
struct RefinePoseSettings {
  double planar_scale_m = 0.12;
  double height_scale_m = 0.25;
  double axis_scale_deg = 0.7;
  double tilt_prior_deg = 1.0;
  bool height_prior = true;
  double height_prior_m = 0.08;
  double height_prior_per_m = 0.04;
  double height_bias_m = 0.3;
  int iterations = 6;
  Fields fields(const std::string& prefix);
};

struct RefinedPose {
  PlanarPose planar;                    ///< in the aligned frames
  RigidTransform candidate_from_query;  ///< in the scenes' own frames
};

/// From one-to-one tree pairs: robust yaw, x and y; then, with these fixed, height, roll and pitch from base heights and
/// stem axes together, with a prior that axis alignment already left the scenes upright and, where a carried sensor stood in
/// both, that its height above the ground was the same.
RefinedPose refine_pose(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs, const PlanarPose& start,
                        const RefinePoseSettings& settings);

}  // namespace stemwise::treeloc
