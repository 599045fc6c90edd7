#include "app/commands/evaluate.hpp"

#include <chrono>
#include <iostream>

#include <sys/resource.h>

#include "app/commands/evaluation_output.hpp"
#include "core/base/parallel.hpp"
#include "core/survey/build_global_inventory.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "io/read_frame_folder.hpp"
#include "io/read_regions.hpp"

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Everything that a run needs, step by step; each step gives the exit code that ends the run, or done.
class EvaluateRun {
public:
  EvaluateRun(const EvaluateOptions& options, Session& session) : options_(options), session_(session) {}

  ExitCode run() {
    for (const auto step : {&EvaluateRun::choose_settings, &EvaluateRun::read_test_regions, &EvaluateRun::read_and_describe}) {
      if (const ExitCode code = (this->*step)(); code != ExitCode::done) return code;
    }
    const Progress progress = session_.progress().stage(0.3, 1.0);
    const treeloc::Evaluation evaluation =
        inter() ? evaluate_inter(std::move(queries_), std::move(map_), regions_, settings_, protocol_, session_.common.threads,
                                 progress)
                : evaluate_intra(std::move(queries_), settings_, protocol_, session_.common.threads, progress);
    return write(evaluation);
  }

private:
  bool inter() const { return !options_.map_folder.empty(); }

  ExitCode choose_settings() {
    const auto method = treeloc::method_from(options_.method);
    std::string preset = "auto";
    for (const auto& [key, value] : given_settings(session_.common).values) {
      if (key == "preset") preset = value;
    }
    const bool known_preset = preset == "auto" || preset == "plot" || preset == "route";
    const bool known_mode = options_.map_mode == "frames" || options_.map_mode == "global";
    if (options_.map_mode == "global" && !inter()) {
      session_.console.error("--map-mode global is for evaluate inter");
      return ExitCode::usage;
    }
    if (!method || !known_preset || !known_mode) {
      session_.console.error("methods: stemwise, treeloc++, treeloc; presets: auto, plot, route; map modes: frames, global");
      return ExitCode::usage;
    }
    settings_ = treeloc::settings_for(*method, preset);
    settings_.seed = session_.common.seed;
    Fields fields = settings_.fields();
    for (Field& f : protocol_.fields("protocol")) fields.push_back(std::move(f));
    fields.push_back({"preset", "", "auto, plot or route", &preset});
    if (const ExitCode code = session_.apply_settings(std::move(fields)); code != ExitCode::done) return code;
    const Issues wrong = settings_.check();
    session_.console.issues(wrong);
    return has_error(wrong) ? ExitCode::usage : ExitCode::done;
  }

  ExitCode read_test_regions() {
    if (options_.regions.empty()) return ExitCode::done;
    const auto colon = options_.regions.rfind(':');
    if (colon == std::string::npos || !inter()) {
      session_.console.error("--regions takes FILE:KEY, for evaluate inter");
      return ExitCode::usage;
    }
    auto read = read_regions(options_.regions.substr(0, colon), options_.regions.substr(colon + 1));
    session_.console.issues(read.issues);
    if (!read) return ExitCode::unusable_input;
    regions_ = std::move(*read);
    return ExitCode::done;
  }

  /// The map first: what "auto" derives from a survey it derives from the map.
  ExitCode read_and_describe() {
    if (inter()) {
      if (const ExitCode code = read_scenes(options_.map_folder, true); code != ExitCode::done) return code;
    }
    return read_scenes(options_.query_folder, !inter());
  }

  ExitCode read_scenes(const std::string& folder, bool is_map) {
    session_.progress().at(is_map ? 0.0 : 0.15, "Reading " + folder);
    const auto start = Clock::now();
    const auto inventory = read_frame_folder(folder, session_.common.threads);
    about_.read_s += seconds_since(start);
    session_.console.issues(inventory.issues);
    if (!inventory) return ExitCode::unusable_input;
    if (is_map) settings_ = treeloc::resolve_settings(settings_, *inventory->frames);
    const auto described = Clock::now();
    const bool global = is_map && options_.map_mode == "global";
    auto scenes =
        global ? global_scenes(*inventory->frames)
               : treeloc::prepare_frame_scenes(*inventory->frames, settings_.scene, settings_.axes, session_.common.threads);
    about_.describe_s += seconds_since(described);
    (inter() && is_map ? map_ : queries_) = std::move(scenes);
    if (is_map) about_.map = inventory->name;
    about_.query = inventory->name;
    return ExitCode::done;
  }

  /// Relocalisation (method.md, section 9): the map's trees as one list, cut on a grid.
  std::vector<treeloc::Scene> global_scenes(const FrameSet& frames) {
    constexpr double grid_spacing_m = 5.0;
    constexpr int grid_min_trees = 10;
    const GlobalInventory global = build_global_inventory(frames, {}, session_.progress().stage(0.05, 0.15));
    return treeloc::prepare_grid_scenes(global.stems, grid_spacing_m, grid_min_trees, settings_.scene, settings_.axes,
                                        session_.common.threads);
  }

  ExitCode write(const treeloc::Evaluation& evaluation) {
    about_.mode = inter() ? "inter" : "intra";
    about_.method = options_.method;
    about_.threads = session_.common.threads > 0 ? session_.common.threads : hardware_threads();
    about_.describe_s += evaluation.timing.index_s;
    about_.peak_rss_mb = peak_rss_mb();
    session_.console.end_progress();
    if (!session_.common.quiet && session_.common.json != "-") std::cout << evaluation_text(evaluation, about_) << std::flush;
    if (!options_.csv.empty()) {
      const Issues wrong = write_text_file(options_.csv, evaluation_csv(evaluation));
      session_.console.issues(wrong);
      if (has_error(wrong)) return ExitCode::failed;
    }
    const ExitCode written = session_.write_json(evaluation_json(evaluation, about_));
    if (written == ExitCode::done && evaluation.rows.empty()) {
      session_.console.error("no query has a scene of the map within " + std::to_string(protocol_.positive_m) +
                             " m: nothing to measure");
      return ExitCode::failed;
    }
    return written;
  }

  const EvaluateOptions& options_;
  Session& session_;
  treeloc::Settings settings_;
  treeloc::EvaluateSettings protocol_;
  std::vector<Polygon> regions_;
  std::vector<treeloc::Scene> queries_, map_;
  EvaluationAbout about_;
};

}  // namespace

ExitCode run_evaluate(const EvaluateOptions& options, Session& session) { return EvaluateRun(options, session).run(); }

}  // namespace stemwise
