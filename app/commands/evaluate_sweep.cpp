#include <algorithm>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/check_output.hpp"
#include "app/commands/evaluate.hpp"
#include "app/commands/sweep_cases.hpp"
#include "core/treeloc/perturb_frames.hpp"
#include "core/treeloc/session_pairs.hpp"

namespace stemwise {
namespace {

using treeloc::Evaluation;

/// What a table says of a case: mean over the trials, and the standard deviation of R@1 and MF1.
struct SweepRow {
  std::string what, name;
  std::size_t trials = 0, queries = 0;
  std::vector<double> values;
};

struct Column {
  const char* name;
  double (*of)(const Evaluation&);
};
const treeloc::PoseMetrics& poses(const Evaluation& e) { return e.pose_3d_truth_aligned ? *e.pose_3d_truth_aligned : e.pose_3d; }
constexpr Column columns[] = {{"recall_at_1", [](const Evaluation& e) { return e.retrieval.recall_at_1; }},
                              {"mr", [](const Evaluation& e) { return e.retrieval.mr; }},
                              {"mf1", [](const Evaluation& e) { return e.retrieval.mf1; }},
                              {"auc", [](const Evaluation& e) { return e.retrieval.auc; }},
                              {"r50_3d", [](const Evaluation& e) { return poses(e).r50; }},
                              {"ate_m", [](const Evaluation& e) { return poses(e).ate_m; }},
                              {"are_deg", [](const Evaluation& e) { return poses(e).are_deg; }},
                              {"accepted", [](const Evaluation& e) { return static_cast<double>(e.accepted); }},
                              {"accepted_wrong_by_more_than_1_m", [](const Evaluation& e) { return static_cast<double>(e.accepted_wrong); }}};

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

SweepRow row_of(const SweepCase& c, const std::vector<Evaluation>& trials) {
  SweepRow row{c.what, c.name, trials.size(), trials.front().rows.size(), {}};
  std::vector<double> recall, mf1;
  for (const Evaluation& e : trials) recall.push_back(e.retrieval.recall_at_1), mf1.push_back(e.retrieval.mf1);
  for (const Column& column : columns) {
    double mean = 0.0;
    for (const Evaluation& e : trials) mean += column.of(e) / static_cast<double>(trials.size());
    row.values.push_back(mean);
  }
  row.values.push_back(treeloc::stability_of(recall).sd);
  row.values.push_back(treeloc::stability_of(mf1).sd);
  return row;
}

std::vector<std::string> headings() {
  std::vector<std::string> names{"what", "case", "trials", "queries"};
  for (const Column& column : columns) names.emplace_back(column.name);
  names.emplace_back("recall_at_1_sd");
  names.emplace_back("mf1_sd");
  return names;
}

std::vector<std::string> cells_of(const SweepRow& row) {
  std::vector<std::string> cells{row.what, row.name, std::to_string(row.trials), std::to_string(row.queries)};
  for (const double value : row.values) cells.push_back(short_number(value));
  return cells;
}

std::string line_of(const std::vector<std::string>& cells, bool is_markdown) {
  std::string line = is_markdown ? "| " : "";
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : is_markdown ? " | " : ",") + cells[i];
  return line + (is_markdown ? " |\n" : "\n");
}

std::string table_text(const std::vector<SweepRow>& rows, bool is_markdown) {
  std::string text = line_of(headings(), is_markdown);
  if (is_markdown) text += line_of(std::vector<std::string>(headings().size(), "---"), true);
  for (const SweepRow& row : rows) text += line_of(cells_of(row), is_markdown);
  return text;
}

class SweepRun {
 public:
  SweepRun(const EvaluateSweepOptions& options, Session& session) : options_(options), session_(session), setup_(options.method, session) {}

  ExitCode run() {
    for (const auto step : {&SweepRun::check, &SweepRun::read}) {
      if (const ExitCode code = (this->*step)(); code != ExitCode::done) return code;
    }
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const double all = static_cast<double>(cases_.size());
      const Progress progress = session_.progress().stage(0.05 + 0.95 * static_cast<double>(i) / all, 0.05 + 0.95 * static_cast<double>(i + 1) / all);
      progress.at(0.0, cases_[i].name);
      measure(cases_[i], progress);
    }
    return write();
  }

 private:
  bool inter() const { return !options_.map_folder.empty(); }

  ExitCode check() {
    const auto names = sweep_names();
    if (options_.what != "all" && std::find(names.begin(), names.end(), options_.what) == names.end()) {
      session_.console.error("--what takes ablations, deletion, noise, rotation, radius, sigma_t, defaults or all");
      return ExitCode::usage;
    }
    const bool known_suffix = options_.output.empty() || options_.output.ends_with(".csv") || options_.output.ends_with(".md");
    if (!known_suffix || options_.trials < 1) {
      session_.console.error("-o takes a .csv or .md file; --trials at least 1");
      return ExitCode::usage;
    }
    const bool is_markdown = options_.output.ends_with(".md");
    const std::vector<std::string> inputs{options_.query_folder, options_.map_folder, setup_.regions_file()};
    if (const ExitCode code = check_table_target("-o", options_.output, is_markdown ? "| what | case |" : "what,case,", inputs, session_.common, session_.console);
        code != ExitCode::done)
      return code;
    if (!inter() && (setup_.is_global() || !options_.method.regions.empty())) {
      session_.console.error("--map-mode global and --regions need a MAP_DIR");
      return ExitCode::usage;
    }
    return setup_.check();
  }

  ExitCode read() {
    session_.progress().at(0.0, "Reading " + options_.query_folder);
    auto query = setup_.read(options_.query_folder);
    if (!query) return ExitCode::unusable_input;
    query_ = query->frames;
    map_ = query_;
    if (inter()) {
      auto map = setup_.read(options_.map_folder);
      if (!map) return ExitCode::unusable_input;
      map_ = map->frames;
    }
    for (const std::string& what : sweep_names()) {
      if (options_.what != "all" && options_.what != what) continue;
      const auto more = sweep_cases(what, *treeloc::method_from(options_.method.method), setup_.settings());
      cases_.insert(cases_.end(), more.begin(), more.end());
    }
    return ExitCode::done;
  }

  /// Query and map as this case and trial has them. Intra: one survey, so what turns or deletes does it to all of it; noise too.
  Evaluation evaluate(const SweepCase& c, std::uint64_t seed, const Progress& progress) const {
    const treeloc::Settings settings = setup_.settings(c.settings);
    treeloc::EvaluateSettings protocol = setup_.protocol();
    protocol.with_negatives = false;
    const int threads = session_.common.threads;
    FrameSet query = *query_, map;
    if (c.deleted_share > 0.0) query = treeloc::delete_trees(query, c.deleted_share, seed);
    if (c.center_noise_m > 0.0 || c.dbh_noise_m > 0.0) query = treeloc::add_noise(query, c.center_noise_m, c.dbh_noise_m, seed + 7919);
    if (!inter()) {
      if (c.turns()) query = every_second_turned(query, c.map_turned);
      return evaluate_intra(setup_.query_scenes(query, settings), settings, protocol, threads, progress);
    }
    map = *map_;
    if (c.deleted_share > 0.0) map = treeloc::delete_trees(map, c.deleted_share, seed + 104729);
    if (c.turns()) map = treeloc::rotate_frames(map, c.map_turned);
    return evaluate_inter(setup_.query_scenes(query, settings), setup_.map_scenes(map, settings), setup_.regions(), settings, protocol, threads,
                          progress);
  }

  /// A survey against itself has no map of its own to turn: every second frame is turned, so that neighbours differ.
  static FrameSet every_second_turned(const FrameSet& frames, const RollPitchYaw& turn) {
    FrameSet turned = treeloc::rotate_frames(frames, turn);
    for (std::size_t i = 0; i < turned.frames.size(); i += 2) turned.frames[i] = frames.frames[i];
    return turned;
  }

  void measure(const SweepCase& c, const Progress& progress) {
    std::vector<Evaluation> trials;
    const int count = c.is_random ? options_.trials : 1;
    for (int trial = 0; trial < count; ++trial) {
      const Progress part = progress.stage(static_cast<double>(trial) / count, static_cast<double>(trial + 1) / count);
      trials.push_back(evaluate(c, session_.common.seed * 1000003 + static_cast<std::uint64_t>(trial), part));
    }
    rows_.push_back(row_of(c, trials));
  }

  ExitCode write() {
    session_.console.end_progress();
    if (!session_.common.quiet && session_.common.json != "-") std::cout << table_text(rows_, true) << std::flush;
    if (!options_.output.empty()) {
      const Issues wrong = write_result(options_.output, table_text(rows_, options_.output.ends_with(".md")));
      session_.console.issues(wrong);
      if (has_error(wrong)) return ExitCode::failed;
    }
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool anything = false;
    for (const SweepRow& row : rows_) {
      nlohmann::ordered_json json{{"what", row.what}, {"case", row.name}, {"trials", row.trials}, {"queries", row.queries}};
      const auto names = headings();
      for (std::size_t i = 0; i < row.values.size(); ++i) json[names[i + 4]] = row.values[i];
      rows.push_back(std::move(json));
      anything = anything || row.queries > 0;
    }
    const nlohmann::ordered_json json{{"mode", "sweep"}, {"method", options_.method.method}, {"seed", session_.common.seed}, {"rows", rows}};
    const ExitCode written = session_.write_json(json.dump(2) + "\n");
    if (written != ExitCode::done || anything) return written;
    session_.console.error("no query has a scene of the map nearby: nothing to measure");
    return ExitCode::failed;
  }

  const EvaluateSweepOptions& options_;
  Session& session_;
  EvaluateSetup setup_;
  std::shared_ptr<const FrameSet> query_, map_;
  std::vector<SweepCase> cases_;
  std::vector<SweepRow> rows_;
};

}  // namespace

ExitCode run_evaluate_sweep(const EvaluateSweepOptions& options, Session& session) { return SweepRun(options, session).run(); }

}  // namespace stemwise
