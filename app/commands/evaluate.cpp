#include "app/commands/evaluate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <sys/resource.h>

#include "app/check_output.hpp"
#include "app/commands/evaluation_output.hpp"
#include "app/commands/evaluation_plots.hpp"
#include "app/platform/folders.hpp"
#include "core/base/parallel.hpp"
#include "io/survey_reader.hpp"

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Nothing is kept without a home folder.
SurveyCacheOptions cache_of(const EvaluateOptions& options) {
  SurveyCacheOptions cache;
  if (options.no_cache) return cache;
  cache.folder = !options.cache.empty() ? options.cache : platform::cache_folder();
  cache.program = platform::program_stamp();
  if (cache.program.empty()) cache.folder.clear();
  return cache;
}

/// Everything that a run needs, step by step; each step gives the exit code that ends the run, or done.
class EvaluateRun {
public:
  EvaluateRun(const EvaluateOptions& options, Session& session)
      : options_(options), session_(session), setup_(options.method, session), reader_(cache_of(options), session.common.threads) {}

  ExitCode run() {
    for (const auto step : {&EvaluateRun::check, &EvaluateRun::read_and_describe}) {
      if (const ExitCode code = (this->*step)(); code != ExitCode::done) return code;
    }
    const Progress progress = session_.progress().stage(0.3, 1.0);
    const int threads = session_.common.threads;
    const treeloc::Evaluation evaluation =
        inter() ? evaluate_inter(std::move(queries_), std::move(map_), setup_.regions(), settings_, setup_.protocol(), threads, progress)
                : evaluate_intra(std::move(map_), settings_, setup_.protocol(), threads, progress);
    return write(evaluation);
  }

private:
  bool inter() const { return !options_.map_folder.empty(); }

  ExitCode check() {
    if (!inter() && (setup_.is_global() || !options_.method.regions.empty())) {
      session_.console.error("--map-mode global and --regions are for evaluate inter");
      return ExitCode::usage;
    }
    const std::vector<std::string> inputs{options_.query_folder, options_.map_folder, setup_.regions_file()};
    if (const ExitCode code = check_table_target("--csv", options_.csv, "query,candidate,", inputs, session_.common, session_.console); code != ExitCode::done) return code;
    return setup_.check();
  }

  ExitCode read_and_describe() {
    settings_ = setup_.settings();
    if (!inter()) return read_survey(options_.query_folder, true);
    const ExitCode code = setup_.is_global() ? read_global_map() : read_survey(options_.map_folder, true);
    return code == ExitCode::done ? read_survey(options_.query_folder, false) : code;
  }

  ExitCode read_survey(const std::string& folder, bool is_map) {
    session_.progress().at(is_map ? 0.0 : 0.15, "Reading " + folder);
    const bool with_triangles = is_map && settings_.method == treeloc::Method::stemwise;
    auto survey = reader_.read(folder, settings_, with_triangles);
    session_.console.issues(survey.issues);
    if (!survey) return ExitCode::unusable_input;
    if (std::all_of(survey->described.scenes.begin(), survey->described.scenes.end(), [](const treeloc::Scene& scene) { return scene.trees.empty(); })) {
      session_.console.error(folder + ": no frame has a tree with a diameter within the radius: nothing to localise by");
      return ExitCode::unusable_input;
    }
    about_.read_s += survey->read_s;
    about_.describe_s += survey->describe_s;
    about_.index_s += survey->index_s;
    about_.cache_write_s += survey->keep_s;
    if (is_map) about_.map = survey->name, about_.map_from_cache = survey->scenes_from_cache && survey->triangles_from_cache;
    about_.query = survey->name;
    about_.query_from_cache = survey->scenes_from_cache;
    if (is_map) {
      map_ = std::move(survey->described);
    } else {
      queries_ = std::move(survey->described.scenes);
    }
    return ExitCode::done;
  }

  ExitCode read_global_map() {
    session_.progress().at(0.0, "Reading " + options_.map_folder);
    const auto start = Clock::now();
    const auto inventory = setup_.read(options_.map_folder);
    about_.read_s += seconds_since(start);
    if (!inventory) return ExitCode::unusable_input;
    const auto described = Clock::now();
    map_ = setup_.map_scenes(*inventory->frames, settings_);
    about_.describe_s += seconds_since(described);
    about_.map = inventory->name;
    return ExitCode::done;
  }

  ExitCode write(const treeloc::Evaluation& evaluation) {
    about_.mode = inter() ? "inter" : "intra";
    about_.method = options_.method.method;
    about_.map_mode = options_.method.map_mode;
    about_.threads = session_.common.threads > 0 ? session_.common.threads : hardware_threads();
    about_.describe_s += evaluation.timing.index_s;
    about_.index_s += evaluation.timing.index_s;
    about_.peak_rss_mb = peak_rss_mb();
    session_.console.end_progress();
    if (evaluation.tilt_observed < 1.0 && !evaluation.rows.empty())
      session_.console.warn(std::to_string(std::lround(100.0 * (1.0 - evaluation.tilt_observed))) + " % of the queries have no stem axes: their roll and pitch are not observed");
    if (!session_.common.quiet && session_.common.json != "-" && options_.csv != "-") std::cout << evaluation_text(evaluation, about_) << std::flush;
    Issues wrong;
    if (!options_.csv.empty()) wrong = write_result(options_.csv, evaluation_csv(evaluation));
    if (!options_.plots.empty() && !has_error(wrong)) wrong = write_evaluation_plots(evaluation, about_, options_.plots);
    session_.console.issues(wrong);
    if (has_error(wrong)) return ExitCode::failed;
    const ExitCode written = session_.write_json(evaluation_json(evaluation, about_));
    if (written == ExitCode::done && evaluation.rows.empty()) {
      session_.console.error("no query has a scene of the map within " + std::to_string(setup_.protocol().positive_m) +
                             " m: nothing to measure");
      return ExitCode::failed;
    }
    return written;
  }

  const EvaluateOptions& options_;
  Session& session_;
  EvaluateSetup setup_;
  SurveyReader reader_;
  treeloc::Settings settings_;
  std::vector<treeloc::Scene> queries_;
  treeloc::DescribedScenes map_{{}};
  EvaluationAbout about_;
};

}  // namespace

ExitCode run_evaluate(const EvaluateOptions& options, Session& session) { return EvaluateRun(options, session).run(); }

}  // namespace stemwise
