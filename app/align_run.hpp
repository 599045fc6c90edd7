#pragma once
#include <string>

#include "app/commands/align.hpp"
#include "app/rejected_constraint.hpp"
#include "core/project/project.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

/// Inventories that went the whole road: read, aligned, matched, applied to a project that nobody has written yet.
struct AlignRun {
  ExitCode code = ExitCode::done;  ///< anything else: it ended before there was an alignment, and said why
  std::string problem;             ///< why, in one line, where an input was the reason
  Project project;
  Tables tables;
  std::vector<RejectedConstraint> rejected;
  AlignTiming timing;
  std::uint64_t seed = 0;
};

/// The road of `align` and `batch` alike. Throws Cancelled.
AlignRun run_alignment(const AlignOptions& options, Session& session);

/// A refusal of one of two is a failure; of more, as long as one was aligned to the reference, a warning each.
ExitCode judge_alignment(const ProjectState& state, Console& console);

}  // namespace stemwise
