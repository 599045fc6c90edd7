#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

struct WeightedPose {
  RigidTransform survey_from_query;
  double weight = 1.0;
};

/// Robust mean of poses of the same query in one survey: reweighted (Cauchy kernel) around the first.
RigidTransform fuse_poses(std::span<const WeightedPose> poses, const FusePosesSettings& settings);

}  // namespace stemwise::treeloc
