#include "core/survey/pose_from_frames.hpp"

namespace stemwise {

FramePose pose_from_frames(const Inventory& a, const Inventory& b, const treeloc::MatchSurveysSettings& matching,
                           const JointPoseSettings& joint, int threads, const Progress& progress) {
  FramePose result;
  if (!a.frames || !b.frames || a.frames->frames.empty() || b.frames->frames.empty()) return result;
  std::vector<PoseConstraint> constraints;
  for (const treeloc::SceneConstraint& scene : treeloc::match_surveys(*a.frames, *b.frames, matching, threads, progress)) {
    const Eigen::Vector3d scene_in_b = b.frames->frames[scene.scene_b].pose.survey_from_frame.translation_m;
    constraints.push_back({0, 1, scene.a_from_b, scene_in_b, 1.0});
  }
  const JointPoseReport report = estimate_joint_poses(2, 0, constraints, joint);
  result.constraints = static_cast<int>(constraints.size());
  for (const char accepted : report.accepted) result.accepted += accepted;
  result.a_from_b = report.reference_from_survey[1];
  return result;
}

}  // namespace stemwise
