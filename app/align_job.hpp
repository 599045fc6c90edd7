#pragma once
#include <utility>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/align_surveys.hpp"

namespace stemwise {

/// What aligning a project gives: everything that the command apply_alignment takes.
struct AlignOutcome {
  SurveyAlignment alignment;
  std::vector<std::pair<InventoryId, Coverage>> coverages;
};

/// Aligns all inventories of a snapshot, by the window and by the command line alike. Decisions by hand in the project are
/// added to `hints`: linked and accepted matches must join, rejected ones must not. Throws Cancelled.
AlignOutcome align_project(const ProjectState& state, const AlignSettings& settings, AlignHints hints, const Progress& progress);

/// The same for inventories that were added to an aligned project: what is aligned stays exactly as it is (poses, matches,
/// trees), only the others are aligned and matched to it. Removing them again gives back what was there before.
AlignOutcome align_added(const ProjectState& state, const AlignSettings& settings, AlignHints hints, const Progress& progress);

}  // namespace stemwise
