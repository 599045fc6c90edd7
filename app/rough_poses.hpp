#pragma once
#include <vector>

#include "core/project/command.hpp"
#include "core/survey/align_surveys.hpp"

namespace stemwise {

/// The rough positions that a person gave in this project, for every later alignment, in the frame of the reference of now. One
/// that was given for a reference that has no place any more means nothing.
std::vector<AlignHints::RoughPose> rough_poses(const ProjectState& state);
/// Keeps one, instead of an earlier one of the same survey.
CommandPtr keep_rough_pose(const ProjectState& state, const AlignHints::RoughPose& rough, EditStamp stamp);
/// A person takes the pose that was found probable: every alignment from now on accepts what it finds there.
CommandPtr accept_proposed_pose(const ProjectState& state, InventoryId id, EditStamp stamp);

}  // namespace stemwise
