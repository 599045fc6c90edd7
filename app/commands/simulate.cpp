#include "app/commands/simulate.hpp"

#include <algorithm>
#include <filesystem>

#include "app/read_inputs.hpp"
#include "app/result_json.hpp"
#include "app/truth_files.hpp"
#include "io/write_inventory.hpp"
#include "io/write_whole_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

/// Writes one thing after the other until one cannot be written.
class FolderWriter {
 public:
  FolderWriter(std::string folder, Console& console) : folder_(std::move(folder)), console_(console) {
    std::error_code code;
    fs::create_directories(fs::path(folder_) / "truth", code);
    if (code) take(Result<Done>::failure(Issue{Severity::error, folder_, 0, "", "cannot be made: " + code.message(), ""}));
  }
  void survey(const std::string& name, const Inventory& inventory, bool frames) {
    if (failed_) return;
    written_.push_back(frames ? name : name + ".csv");
    take(write_inventory((fs::path(folder_) / (frames ? name : name + ".csv")).string(), inventory));
    if (!failed_) console_.say(name + ": " + (frames ? std::to_string(inventory.frames->frames.size()) + " frames" : std::to_string(inventory.stems.size()) + " stems"));
  }
  void truth(const std::string& file, const std::string& text) {
    if (!failed_) take(write_whole_file((fs::path(folder_) / "truth" / file).string(), text));
  }
  ExitCode finish(Session& session) const {
    if (failed_) return ExitCode::failed;
    return session.write_json(result_json({{"output", folder_}, {"surveys", written_}, {"truth", std::vector<std::string>{"truth/trees.csv", "truth/poses.json"}}}));
  }

 private:
  void take(const Result<Done>& done) {
    console_.issues(done.issues);
    failed_ = failed_ || !done;
  }

  std::string folder_;
  Console& console_;
  std::vector<std::string> written_;
  bool failed_ = false;
};

/// A folder that no earlier simulation made may hold somebody's surveys of the same names.
ExitCode check_folder(const std::string& folder, const std::vector<std::string>& names, Console& console) {
  if (fs::exists(fs::path(folder) / "truth" / "poses.json")) return ExitCode::done;
  for (const std::string& name : names)
    for (const fs::path& path : {fs::path(folder) / name, fs::path(folder) / (name + ".csv")}) {
      if (!fs::exists(path)) continue;
      console.error("-o " + folder + ": " + path.string() + " is there and was not simulated, and writing would destroy it; choose another folder");
      return ExitCode::usage;
    }
  return ExitCode::done;
}

ExitCode write_forest(const SimulatedForest& forest, const SimulateOptions& options, Session& session) {
  std::vector<std::string> names;
  for (const SimulatedSurvey& survey : forest.surveys) names.push_back(std::to_string(year_of(*survey.inventory.date)));
  if (const ExitCode code = check_folder(options.folder, names, session.console); code != ExitCode::done) return code;
  FolderWriter writer(options.folder, session.console);
  for (std::size_t i = 0; i < names.size(); ++i) writer.survey(names[i], forest.surveys[i].inventory, options.settings.frames);
  writer.truth("trees.csv", truth_trees_csv(forest, names));
  writer.truth("poses.json", truth_poses_json(forest, names));
  return writer.finish(session);
}

ExitCode resurvey(const SimulateOptions& options, const SimulateSettings& settings, Session& session) {
  const ReadInputs read = read_inputs({options.resurvey}, options.read, session, session.progress());
  session.console.end_progress();
  session.console.issues(read.usage);
  if (has_error(read.usage)) return ExitCode::usage;
  const Result<Inventory>& inventory = read.inputs.front().inventory;
  session.console.issues(inventory.issues);
  if (!inventory) return ExitCode::unusable_input;
  if (settings.frames && !inventory->frames) {
    session.console.error("--frames: " + options.resurvey + " is a list of stems, and a list is surveyed once more as a list; leave --frames out");
    return ExitCode::usage;
  }
  const SimulatedForest forest = simulate_resurvey(*inventory, settings);
  if (const ExitCode code = check_folder(options.folder, {"resurvey"}, session.console); code != ExitCode::done) return code;
  FolderWriter writer(options.folder, session.console);
  writer.survey("resurvey", forest.surveys.front().inventory, inventory->frames != nullptr);
  writer.truth("trees.csv", truth_trees_csv(forest, {"before", "resurvey"}));
  writer.truth("poses.json", truth_poses_json(forest, {"resurvey"}));
  return writer.finish(session);
}

}  // namespace

ExitCode run_simulate(const SimulateOptions& options, Session& session) {
  SimulateSettings settings = options.settings;
  settings.seed = session.common.seed;
  for (const int year : options.years) settings.dates.push_back(date_from_civil(year, 7, 1));
  if (std::adjacent_find(settings.dates.begin(), settings.dates.end()) != settings.dates.end()) {
    session.console.error("--years: every year may stand there once");
    return ExitCode::usage;
  }
  if (const ExitCode code = session.apply_settings(settings.fields()); code != ExitCode::done) return code;
  const Issues wrong = settings.check();
  session.console.issues(as_settings(wrong, "simulate."));
  if (has_error(wrong)) return ExitCode::usage;
  if (!options.resurvey.empty()) return resurvey(options, settings, session);
  const SimulatedForest forest = simulate_forest(settings, session.progress());
  session.console.end_progress();
  return write_forest(forest, options, session);
}

}  // namespace stemwise
