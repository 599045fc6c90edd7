#include "app/commands/align.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/align_job.hpp"
#include "app/align_json.hpp"
#include "app/hint_file.hpp"
#include "app/load_inventories.hpp"
#include "core/project/commands.hpp"
#include "core/project/project.hpp"
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

/// A refusal of one of two is a failure; of more, as long as one was aligned, a warning each.
ExitCode judge(const ProjectState& state, Console& console) {
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

/// Before the work, what would only be noticed after it.
ExitCode check_output(const std::string& path, Console& console) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  std::error_code code;
  if (std::filesystem::is_directory(folder, code)) return ExitCode::done;
  console.error(path + ": cannot be written, there is no folder " + folder.string());
  return ExitCode::failed;
}

AlignSettings settings_of(const AlignOptions& options, const Session& session) {
  AlignSettings settings;
  settings.seed = session.common.seed;
  settings.threads = session.common.threads;
  settings.accept_probable = options.accept_probable;
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

}  // namespace

ExitCode run_align(const AlignOptions& options, Session& session) {
  const Clock::time_point start = Clock::now();
  AlignSettings settings = settings_of(options, session);
  if (const ExitCode code = session.apply_settings(settings.fields()); code != ExitCode::done) return code;
  if (const ExitCode code = check_output(options.output, session.console); code != ExitCode::done) return code;
  const Progress progress = session.progress();

  LoadedInventories loaded = load_inventories(options.inventories, options.read, session, progress.stage(0.0, 0.3));
  if (loaded.code != ExitCode::done) return loaded.code;
  const double read_s = seconds_since(start);
  Project project;
  if (const ExitCode code = add_all(std::move(loaded.inventories), options, project, session.console); code != ExitCode::done) return code;
  remember_settings(session, project);
  AlignHints hints;
  if (const ExitCode code = read_hints(options, project, session.console, hints); code != ExitCode::done) return code;

  AlignOutcome outcome = align_project(project.state(), settings, hints, progress.stage(0.3, 0.95));
  AlignTiming timing = outcome.alignment.timing;
  for (const std::string& note : outcome.alignment.notes) session.console.say("note: " + note);
  project.execute(apply_alignment(std::move(outcome.alignment), std::move(outcome.coverages)));
  progress.at(0.95, "Deriving growth and fates");
  const Tables tables = derive_tables(project.state());
  session.console.end_progress();
  const ExitCode verdict = judge(project.state(), session.console);
  if (verdict == ExitCode::done) {
    const Result<Done> written = write_project(project.state(), options.output);
    session.console.issues(written.issues);
    if (!written) return ExitCode::failed;
  }
  timing.read_s = read_s;
  timing.total_s = seconds_since(start);
  session.console.say(align_text(project.state(), tables));
  const ExitCode json = session.write_json(align_json(project.state(), tables, timing, settings.seed));
  return verdict != ExitCode::done ? verdict : json;
}

}  // namespace stemwise
