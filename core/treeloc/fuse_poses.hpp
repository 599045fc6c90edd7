#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise::treeloc {

/// Putting the poses together that several verified scenes give (method.md, section 12).
struct FusePosesSettings {
  bool enabled = true;
  int most = 20;
  double position_scale_m = 0.15;
  double rotation_scale_deg = 1.0;
  Fields fields(const std::string& prefix);
};

struct WeightedPose {
  RigidTransform survey_from_query;
  double weight = 1.0;
};

/// Robust mean of poses of the same query in one survey: reweighted (Cauchy kernel) around the first.
RigidTransform fuse_poses(std::span<const WeightedPose> poses, const FusePosesSettings& settings);

}  // namespace stemwise::treeloc
