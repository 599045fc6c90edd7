#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "app/rejected_constraint.hpp"
#include "core/project/command.hpp"
#include "core/survey/align_surveys.hpp"
#include "core/survey/register_trajectories.hpp"

namespace stemwise {

/// Every setting of the road from surveys to matches.
struct AlignJobSettings {
  AlignSettings align;
  RegisterSettings registering;
  bool one_crs = false;  ///< all surveys are in one coordinate system: that is the prior of those that cannot prove their place
  Fields fields();
  Issues check();  ///< what makes no sense; the key stands in `column`
};

/// What aligning a project gives: what apply_outcome makes a command of.
struct AlignOutcome {
  std::vector<std::shared_ptr<const Inventory>> corrected;  ///< surveys whose trajectory had drifted, with their stems made anew
  SurveyAlignment alignment;
  std::vector<RejectedConstraint> rejected;  ///< by the estimate of the trajectories, the farthest off first
  std::vector<std::pair<InventoryId, Coverage>> coverages;
};

/// Aligns all inventories of a snapshot, by the window and by the command line alike: drift out of trajectories first (of
/// surveys that have no place and no decisions yet), then poses and matches. Decisions by hand in the project are added to
/// `hints`: linked and accepted matches must join, rejected ones must not, rough positions count again. Throws Cancelled.
AlignOutcome align_project(const ProjectState& state, const AlignJobSettings& settings, AlignHints hints, const Progress& progress);

/// The same for inventories that were added to an aligned project: what is aligned stays exactly as it is (poses, matches,
/// trees), only the others are aligned and matched to it. Removing them again gives back what was there before.
AlignOutcome align_added(const ProjectState& state, const AlignJobSettings& settings, AlignHints hints, const Progress& progress);

/// One command for all of it.
CommandPtr apply_outcome(AlignOutcome outcome);

}  // namespace stemwise
