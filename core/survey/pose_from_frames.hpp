#pragma once
#include <optional>

#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"
#include "core/survey/joint_pose.hpp"
#include "core/treeloc/match_surveys.hpp"

namespace stemwise {

/// What the frames of two surveys say about their relative pose.
struct FramePose {
  std::optional<RigidTransform> a_from_b;  ///< empty when no pose is supported by enough scenes
  int constraints = 0;                     ///< scenes of b recognised in a
  int accepted = 0;                        ///< of these, in agreement with the pose
};

/// TreeLoc++ between the frames of two surveys, then one robust rigid pose from all scenes that were recognised (method.md
/// 9). A proposal: it is verified like every other pose. Nothing when one of them has no frames. Throws Cancelled.
FramePose pose_from_frames(const Inventory& a, const Inventory& b, const treeloc::MatchSurveysSettings& matching,
                           const JointPoseSettings& joint, int threads, const Progress& progress);

}  // namespace stemwise
