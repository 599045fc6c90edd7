#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "app/rejected_constraint.hpp"

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

/// The JSON text of `align --json` (cli.md) of a project whose alignment has been applied.
std::string align_json(const ProjectState& state, const Tables& tables, std::span<const RejectedConstraint> rejected, const AlignTiming& timing, std::uint64_t seed);
/// Counts of the merged trees by fate and so on, for the lines a person reads after `align`.
std::string align_text(const ProjectState& state, const Tables& tables);

}  // namespace stemwise
