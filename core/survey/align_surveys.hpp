#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"
#include "core/survey/align_base.hpp"
#include "core/survey/alignment.hpp"
#include "core/survey/joint_pose.hpp"
#include "core/survey/level_by_axes.hpp"
#include "core/survey/list_settings.hpp"
#include "core/survey/refine_six_dof.hpp"
#include "core/treeloc/match_surveys.hpp"

namespace stemwise {

/// What a person already knows or has decided (product.md, "decisions by hand bind every later run").
struct AlignHints {
  struct SameTree {
    StemRef a;
    StemRef b;
    bool decided = false;  ///< in the review of an earlier run, not to help this one along
  };
  struct RoughPose {
    InventoryId inventory;
    double x_m = 0.0, y_m = 0.0;  ///< of the inventory's origin in the reference
    double yaw_rad = 0.0;
    double radius_m = 10.0;       ///< how far off it may be
    double yaw_radius_rad = 0.35;
    Eigen::Vector2d about_m = Eigen::Vector2d::Zero();  ///< the point of the inventory that `radius_m` counts from
    bool accepted = false;    ///< a person looked at this pose and takes it
    bool same_stand = false;  ///< both in one coordinate system: a small plot need not prove that it is the same stand
  };
  std::vector<SameTree> same_tree;   ///< linked or accepted: must join
  std::vector<SameTree> not_same;    ///< rejected or unlinked: must not join
  std::vector<RoughPose> rough_poses;
  AlignBase base;                    ///< surveys are added to this, which does not change
};

struct AlignSettings {
  std::string preset = "auto";  ///< TreeLoc++ parameters for frames: auto, plot, route
  std::uint64_t seed = 0;
  int threads = 0;              ///< 0: all; the result does not depend on it
  bool accept_probable = false; ///< probable poses count as accepted
  ListSettings lists;           ///< bare stem lists (stem-lists.md)
  LevelSettings level;          ///< uprighting lists that have axes
  SixDofSettings six_dof;       ///< roll, pitch and height from matched stems
  treeloc::MatchSurveysSettings scenes;  ///< frames of one survey looked for in another
  JointPoseSettings joint;      ///< one rigid pose from all scenes that were recognised
  Fields fields();              ///< every setting below and of the steps
};

/// Aligns every inventory to the reference and matches their stems (method.md 9, stem-lists.md). No first guess is
/// needed. `reference` 0: the inventory with the most trees. Never throws for bad data: a refusal is a status with a
/// reason. With a base only the others are aligned, to it; the result's matches are then those that join one of them.
/// Throws Cancelled.
SurveyAlignment align_surveys(std::span<const Inventory* const> inventories, InventoryId reference, const AlignSettings& settings,
                              const AlignHints& hints, const Progress& progress);

}  // namespace stemwise
