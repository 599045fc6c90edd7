#include "app/align_run.hpp"

#include <algorithm>
#include <chrono>

#include "app/align_job.hpp"
#include "app/commands/placement.hpp"
#include "app/hint_file.hpp"
#include "app/load_inventories.hpp"
#include "core/project/commands.hpp"
#include "io/crs.hpp"
#include "io/project_file.hpp"

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

ExitCode add_all(std::vector<Inventory> inventories, const AlignOptions& options, Project& project, Console& console) {
  for (Inventory& inventory : inventories) project.execute(add_inventory(std::move(inventory)));
  if (options.reference.empty()) return ExitCode::done;
  const Inventory* reference = project.state().find(options.reference);
  if (reference == nullptr) {
    std::string names;
    for (const auto& inventory : project.state().inventories) names += (names.empty() ? "" : ", ") + inventory->name;
    console.error("--reference " + options.reference + ": there is no inventory of that name (there are " + names + ")");
    return ExitCode::usage;
  }
  if (reference->id != project.state().reference) project.execute(set_reference(reference->id));
  return ExitCode::done;
}

AlignJobSettings settings_of(const AlignOptions& options, const Session& session) {
  AlignJobSettings settings;
  settings.align.seed = session.common.seed;
  settings.align.threads = session.common.threads;
  settings.align.accept_probable = options.accept_probable;
  return settings;
}

void remember_settings(const Session& session, Project& project) {
  for (const auto& [key, value] : given_settings(session.common).values) project.execute(set_setting(key, value));
}

ExitCode read_hints(const AlignOptions& options, const Project& project, Console& console, AlignHints& hints) {
  if (options.hint.empty()) return ExitCode::done;
  Result<AlignHints> read = read_hint_file(options.hint, project.state());
  console.issues(read.issues);
  if (!read) return ExitCode::unusable_input;
  hints = std::move(*read);
  return ExitCode::done;
}

/// --crs: the reference's coordinates are the earth's.
ExitCode place_reference(const AlignOptions& options, Project& project, Console& console) {
  if (options.crs.empty()) return ExitCode::done;
  const Placement placement = place_in_crs(*epsg_from(options.crs), *project.state().find(project.state().reference));
  tell(placement, console);
  if (placement.code == ExitCode::done) project.execute(set_georeference(placement.georeference));
  return placement.code;
}

/// A project as the first input is the base that the others are added to: opened, and taken off the list.
ExitCode open_base(const AlignOptions& options, std::vector<std::string>& paths, AlignRun& run, Console& console) {
  if (paths.empty() || !is_project(paths.front())) return ExitCode::done;
  Result<ProjectState> read = read_project(paths.front());
  console.issues(read.issues);
  if (!read) return ExitCode::unusable_input;
  const Inventory* reference = read->find(read->reference);
  if (!options.reference.empty() && reference != nullptr && reference->name != options.reference) {
    console.error("--reference " + options.reference + ": the project " + paths.front() + " has the reference " + reference->name + ", and what is added is aligned to it");
    return ExitCode::usage;
  }
  run.project = Project(std::move(*read));
  paths.erase(paths.begin());
  return ExitCode::done;
}

AlignRun ended(ExitCode code, std::string problem = "") {
  AlignRun run;
  run.code = code;
  run.problem = std::move(problem);
  return run;
}

}  // namespace

AlignRun run_alignment(const AlignOptions& options, Session& session) {
  const Clock::time_point start = Clock::now();
  AlignRun run;
  std::vector<std::string> paths = options.inventories;
  if (const ExitCode code = open_base(options, paths, run, session.console); code != ExitCode::done) return ended(code);
  const bool based = !run.project.state().alignments.empty(), added = !paths.empty();
  AlignJobSettings settings = settings_of(options, session);
  if (const ExitCode code = session.apply_settings(settings.fields()); code != ExitCode::done) return ended(code);
  if (const Issues wrong = as_settings(settings.check()); has_error(wrong)) {
    session.console.issues(wrong);
    return ended(ExitCode::usage);
  }
  if (!options.crs.empty() && !epsg_from(options.crs)) {
    session.console.error("--crs " + options.crs + ": expected EPSG:N of a projected system, for example EPSG:32632");
    return ended(ExitCode::usage);
  }
  const Progress progress = session.progress();
  LoadedInventories loaded = load_inventories(paths, options.read, session, progress.stage(0.0, 0.3));
  if (loaded.code != ExitCode::done) return ended(loaded.code, loaded.problem);
  const double read_s = seconds_since(start);
  if (const ExitCode code = add_all(std::move(loaded.inventories), options, run.project, session.console); code != ExitCode::done) return ended(code);
  if (const ExitCode code = place_reference(options, run.project, session.console); code != ExitCode::done) return ended(code);
  remember_settings(session, run.project);
  AlignHints hints;
  if (const ExitCode code = read_hints(options, run.project, session.console, hints); code != ExitCode::done) return ended(code);

  settings.one_crs = !options.crs.empty();
  AlignOutcome outcome = (based && added ? align_added : align_project)(run.project.state(), settings, hints, progress.stage(0.3, 0.95));
  run.timing = outcome.alignment.timing;
  session.console.end_progress();
  for (const std::string& note : outcome.alignment.notes) session.console.say("note: " + note);
  run.rejected = outcome.rejected;
  run.project.execute(apply_outcome(std::move(outcome)));
  run.tables = derive_tables(run.project.state());
  run.seed = settings.align.seed;
  run.timing.read_s = read_s;
  run.timing.total_s = seconds_since(start);
  return run;
}

ExitCode judge_alignment(const ProjectState& state, Console& console) {
  const auto is_aligned = [](const auto& entry) { return entry.second.status == AlignmentStatus::aligned; };
  const bool any = std::any_of(state.alignments.begin(), state.alignments.end(), is_aligned);
  for (const auto& [id, alignment] : state.alignments) {
    if (alignment.status != AlignmentStatus::failed && alignment.status != AlignmentStatus::probable) continue;
    const std::string line = state.find(id)->name + " was not aligned: " + alignment.reason +
                             (alignment.status == AlignmentStatus::probable ? " (--accept-probable takes the pose as it is)" : "");
    any ? console.warn(line) : console.error(line);
  }
  return any ? ExitCode::done : ExitCode::failed;
}

}  // namespace stemwise
