#include "app/commands/align.hpp"

#include <algorithm>

#include "app/align_json.hpp"
#include "app/align_run.hpp"
#include "app/check_output.hpp"
#include "core/survey/unit_doubt.hpp"
#include "io/project_file.hpp"

namespace stemwise {
namespace {

/// Growth and fates depend on the order of the surveys: where some have no date, it was taken as given.
void warn_of_undated(const ProjectState& state, Console& console) {
  std::string order, undated;
  bool dated = false;
  for (const InventoryId id : state.by_date()) {
    const Inventory& inventory = *state.find(id);
    order += (order.empty() ? "" : ", ") + inventory.name;
    if (inventory.date) dated = true;
    else undated += (undated.empty() ? "" : ", ") + inventory.name;
  }
  if (dated && !undated.empty())
    console.warn("no date is known of " + undated + ": taken in the order given (" + order + "); tell it with --date NAME:2023-05-04");
}

void warn_of_twins(const ProjectState& state, Console& console) {
  for (std::size_t i = 0; i < state.inventories.size(); ++i)
    for (std::size_t k = i + 1; k < state.inventories.size(); ++k)
      if (state.inventories[i]->stems == state.inventories[k]->stems)
        console.warn(state.inventories[i]->name + " and " + state.inventories[k]->name + " hold the very same stems: was one file given twice?");
}

}  // namespace

ExitCode run_align(const AlignOptions& options, Session& session) {
  if (const ExitCode code = check_output(options.output, OutputKind::project, options.inventories, session.console); code != ExitCode::done) return code;
  const ProjectStamp there = project_stamp(options.output);  // a window may save it while this runs
  const bool read_too = std::any_of(options.inventories.begin(), options.inventories.end(), [&](const std::string& path) { return is_project(path); });
  if (!read_too)
    if (const ExitCode code = check_decisions_kept(options.output, session.console); code != ExitCode::done) return code;
  const AlignRun run = run_alignment(options, session);
  if (run.code != ExitCode::done) return run.code;
  session.progress().check();
  const ProjectState& state = run.project.state();
  warn_of_undated(state, session.console);
  warn_of_twins(state, session.console);
  for (const std::string& doubt : unit_doubts(state)) session.console.warn(doubt + " Tell it with --unit dbh=mm (cm, m, in)");
  const ExitCode verdict = judge_alignment(state, session.console);
  if (verdict == ExitCode::done) {
    const auto written = write_project(state, options.output, there);
    session.console.issues(written.issues);
    if (!written) return ExitCode::failed;
  }
  session.console.say(align_text(state, run.tables));
  const ExitCode json = session.write_json(align_json(state, run.tables, run.rejected, run.timing, run.seed));
  return verdict != ExitCode::done ? verdict : json;
}

}  // namespace stemwise
