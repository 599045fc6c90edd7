#include "app/align_run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/align_job.hpp"
#include "app/hint_file.hpp"
#include "app/load_inventories.hpp"
#include "core/project/commands.hpp"
#include "core/survey/register_trajectories.hpp"
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

/// The system that --crs names; nothing without it, or after having said what is wrong.
std::optional<int> crs_of(const AlignOptions& options, Console& console, ExitCode& code) {
  if (options.crs.empty()) return std::nullopt;
  int epsg = 0;
  char end = 0;
  const bool read = std::sscanf(options.crs.c_str(), "EPSG:%d%c", &epsg, &end) == 1 || std::sscanf(options.crs.c_str(), "epsg:%d%c", &epsg, &end) == 1;
  if (read && is_known_epsg(epsg) && !is_geographic_epsg(epsg)) return epsg;
  console.error("--crs " + options.crs + ": expected EPSG:N of a projected system, for example EPSG:32632");
  code = ExitCode::usage;
  return std::nullopt;
}

/// Of inventories in one coordinate system the pose is near the identity: what GNSS and a compass are off by.
void add_crs_priors(const ProjectState& state, const SurveyAlignment& tried, AlignHints& hints) {
  for (const InventoryAlignment& a : tried.inventories) {
    if (a.status != AlignmentStatus::failed && a.status != AlignmentStatus::probable) continue;
    const Inventory& inventory = *state.find(a.inventory);
    AlignHints::RoughPose prior;
    prior.inventory = a.inventory;
    prior.same_stand = true;
    for (const Stem& stem : inventory.stems) prior.about_m += Eigen::Vector2d(stem.x_m, stem.y_m) / static_cast<double>(inventory.stems.size());
    hints.rough_poses.push_back(prior);
  }
}

Georeference georeference_of_crs(int epsg) {
  Georeference georeference;
  georeference.kind = GeoreferenceKind::crs;
  georeference.epsg = epsg;
  georeference.method = "CRS " + crs_name(epsg);
  return georeference;
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
  AlignSettings settings = settings_of(options, session);
  RegisterSettings registering;
  Fields fields = settings.fields();
  for (const Field& field : registering.fields()) fields.push_back(field);
  if (const ExitCode code = session.apply_settings(fields); code != ExitCode::done) return ended(code);
  registering.scenes = settings.scenes;
  registering.lists = settings.lists;
  ExitCode usage = ExitCode::done;
  const std::optional<int> epsg = crs_of(options, session.console, usage);
  if (usage != ExitCode::done) return ended(usage);
  const Progress progress = session.progress();
  LoadedInventories loaded = load_inventories(paths, options.read, session, progress.stage(0.0, 0.3));
  if (loaded.code != ExitCode::done) return ended(loaded.code, loaded.problem);
  const double read_s = seconds_since(start);
  Registered registered = with_registered_trajectories(std::move(loaded.inventories), registering, settings.threads, progress.stage(0.3, 0.4));
  if (const ExitCode code = add_all(std::move(registered.surveys), options, run.project, session.console); code != ExitCode::done) return ended(code);
  remember_settings(session, run.project);
  AlignHints hints;
  if (const ExitCode code = read_hints(options, run.project, session.console, hints); code != ExitCode::done) return ended(code);

  const ProjectState& state = run.project.state();
  const auto work = based && added ? align_added : align_project;
  AlignOutcome outcome = work(state, settings, hints, progress.stage(0.4, epsg ? 0.65 : 0.95));
  if (epsg) {
    const std::size_t given = hints.rough_poses.size();
    add_crs_priors(state, outcome.alignment, hints);
    if (hints.rough_poses.size() > given) outcome = work(state, settings, hints, progress.stage(0.65, 0.95));
    run.project.execute(set_georeference(georeference_of_crs(*epsg)));
  }
  run.timing = outcome.alignment.timing;
  session.console.end_progress();
  for (const std::string& note : registered.report.notes) session.console.say("note: " + note);
  for (const std::string& note : outcome.alignment.notes) session.console.say("note: " + note);
  run.project.execute(apply_alignment(std::move(outcome.alignment), std::move(outcome.coverages)));
  run.tables = derive_tables(run.project.state());
  run.seed = settings.seed;
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
