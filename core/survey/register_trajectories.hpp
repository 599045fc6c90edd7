#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"
#include "core/survey/joint_pose.hpp"
#include "core/survey/list_settings.hpp"
#include "core/survey/pose_graph.hpp"
#include "core/treeloc/match_surveys.hpp"

namespace stemwise {

struct RegisterSettings {
  int loop_gap_frames = 50;           ///< frames nearer to each other in the order of driving are no loop
  double window_m = 16.0;             ///< length of way whose stems are laid onto a bare list at once
  double window_step_m = 8.0;         ///< from one such window to the next
  double least_drift_m = 0.3;         ///< a trajectory that would change by less (root mean square) is left as it is
  double odometry_share = 0.06;       ///< standard deviation of a step, of its length: drift is a bias of every step, so this is wide
  double odometry_yaw_rad_per_m = 0.004;
  double odometry_tilt_rad_per_m = 0.0005;
  double list_accept_log_ratio = 28.0;  ///< of a window next to one already placed: few poses are tried there
  treeloc::MatchSurveysSettings scenes;
  ListSettings lists;
  JointPoseSettings joint{.agreement_m = 3.0, .agreement_per_m = 0.06};
  PoseGraphSettings graph;
  Fields fields();
};

/// One relative pose between two surveys, or within one (a loop), and how it fared.
struct TrajectoryConstraint {
  std::size_t a = 0, b = 0;                    ///< surveys, by index
  std::optional<std::size_t> frame_a, frame_b; ///< index of the frame; nothing for a bare list, which is rigid
  RigidTransform a_from_b;                     ///< between the frames, or from frame to list
  bool accepted = false;
  double residual_m = 0.0;                     ///< planar, after all poses were estimated
};

struct RegisterReport {
  std::vector<std::shared_ptr<const FrameSet>> corrected;  ///< per survey; null where nothing was to correct
  std::vector<double> correction_m;                        ///< per survey: root mean square; 0 where there is no trajectory
  std::vector<TrajectoryConstraint> constraints;
  std::vector<std::size_t> group;                          ///< per survey: equal where constraints connect them; 0 with the first
  std::vector<std::string> notes;
};

/// Drift out of trajectories (method.md 9): one node per pose with odometry between them, one rigid node per bare list; loops
/// within a survey and scenes recognised in another by TreeLoc++, and stretches of way laid onto bare lists; constraints that
/// contradict their neighbours are dropped, all poses estimated together (pose graph, robust), rejected ones listed. A corrected
/// trajectory stays in its survey's own frame: how surveys lie on each other is decided afterwards. Deterministic. Throws Cancelled.
RegisterReport register_trajectories(const std::vector<Inventory>& surveys, const RegisterSettings& settings, int threads, const Progress& progress);

struct Registered {
  std::vector<std::shared_ptr<const Inventory>> corrected;  ///< per survey: with its stems made anew; null where nothing was to correct
  RegisterReport report;
};

/// The surveys whose trajectories had drifted, corrected, their stem lists made anew from them. What may not move (`free` false)
/// counts as a rigid list. Notes go to the source of the survey that they speak of too. Throws Cancelled.
Registered correct_trajectories(std::span<const std::shared_ptr<const Inventory>> surveys, const std::vector<bool>& free, const RegisterSettings& settings,
                                int threads, const Progress& progress);

}  // namespace stemwise
