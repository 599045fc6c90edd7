#include <cstdio>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/check_output.hpp"
#include "app/commands/evaluate.hpp"
#include "app/commands/evaluation_output.hpp"
#include "app/commands/evaluation_plots.hpp"
#include "core/base/parallel.hpp"
#include "core/treeloc/session_pairs.hpp"

namespace stemwise {
namespace {

using Json = nlohmann::ordered_json;
using treeloc::Evaluation;

struct PairResult {
  EvaluationAbout about;
  Evaluation evaluation;
};

/// One figure of a pair, by name, for the means and the table.
struct Figure {
  const char* name;
  double (*of)(const Evaluation&);
};
const treeloc::PoseMetrics& aligned(const Evaluation& e) { return e.pose_3d_truth_aligned ? *e.pose_3d_truth_aligned : e.pose_3d; }
constexpr Figure figures[] = {{"recall_at_1", [](const Evaluation& e) { return e.retrieval.recall_at_1; }},
                              {"mr", [](const Evaluation& e) { return e.retrieval.mr; }},
                              {"mf1", [](const Evaluation& e) { return e.retrieval.mf1; }},
                              {"auc", [](const Evaluation& e) { return e.retrieval.auc; }},
                              {"r50_3d", [](const Evaluation& e) { return e.pose_3d.r50; }},
                              {"r50_3d_truth_aligned", [](const Evaluation& e) { return aligned(e).r50; }},
                              {"ate_m_truth_aligned", [](const Evaluation& e) { return aligned(e).ate_m; }},
                              {"are_deg_truth_aligned", [](const Evaluation& e) { return aligned(e).are_deg; }}};

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

std::vector<double> values_of(const std::vector<PairResult>& pairs, const Figure& figure) {
  std::vector<double> values;
  for (const PairResult& pair : pairs)
    if (!pair.evaluation.rows.empty()) values.push_back(figure.of(pair.evaluation));
  return values;
}

Json means_json(const std::vector<PairResult>& pairs) {
  Json means;
  for (const Figure& figure : figures) {
    const treeloc::Stability s = treeloc::stability_of(values_of(pairs, figure));
    means[figure.name] = {{"mean", s.mean}, {"sd", s.sd}, {"stability", s.stability}};
  }
  return means;
}

/// Thresholds chosen on one pair and used on the others, and the method's fixed one on all.
Json transfer_json(const std::vector<PairResult>& pairs, int thresholds) {
  std::vector<Evaluation> evaluations;
  std::vector<const EvaluationAbout*> abouts;
  for (const PairResult& pair : pairs)
    if (!pair.evaluation.rows.empty()) evaluations.push_back(pair.evaluation), abouts.push_back(&pair.about);
  Json rows = Json::array();
  for (const treeloc::ThresholdTransfer& t : treeloc::transfer_thresholds(evaluations, thresholds)) {
    const EvaluationAbout& about = *abouts[t.chosen_on];
    rows.push_back({{"query", about.query},
                    {"map", about.map},
                    {"threshold", t.threshold},
                    {"f1_there", t.f1_there},
                    {"mean_f1_elsewhere", t.mean_f1_elsewhere},
                    {"worst_f1_elsewhere", t.worst_f1_elsewhere},
                    {"mean_precision_elsewhere", t.mean_precision_elsewhere},
                    {"mean_recall_elsewhere", t.mean_recall_elsewhere}});
  }
  Json fixed = Json::array();
  for (const PairResult& pair : pairs) {
    if (pair.evaluation.rows.empty()) continue;
    const treeloc::AtThreshold at = treeloc::at_threshold(pair.evaluation.rows, pair.evaluation.acceptance_score);
    fixed.push_back({{"query", pair.about.query}, {"map", pair.about.map}, {"precision", at.precision}, {"recall", at.recall},
                     {"f1", at.f1}, {"accepted", at.accepted}, {"no_positive", at.wrong}});
  }
  const double threshold = pairs.empty() ? 0.0 : pairs.front().evaluation.acceptance_score;
  return {{"chosen_by_best_f1", rows}, {"fixed", {{"threshold", threshold}, {"pairs", fixed}}}};
}

std::string pairs_csv(const std::vector<PairResult>& pairs) {
  std::string csv = "query,map,queries,map_scenes";
  for (const Figure& figure : figures) csv += std::string(",") + figure.name;
  csv += ",accepted,accepted_wrong_by_more_than_1_m\n";
  for (const PairResult& pair : pairs) {
    const Evaluation& e = pair.evaluation;
    csv += pair.about.query + "," + pair.about.map + "," + std::to_string(e.rows.size()) + "," + std::to_string(e.map_scenes);
    for (const Figure& figure : figures) csv += "," + short_number(figure.of(e));
    csv += "," + std::to_string(e.accepted) + "," + std::to_string(e.accepted_wrong) + "\n";
  }
  return csv;
}

class PairsRun {
 public:
  PairsRun(const EvaluatePairsOptions& options, Session& session) : options_(options), session_(session), setup_(options.method, session) {}

  ExitCode run() {
    if (options_.folders.size() < 2) {
      session_.console.error("pairs needs two frame folders or more");
      return ExitCode::usage;
    }
    std::vector<std::string> inputs = options_.folders;
    inputs.push_back(setup_.regions_file());
    if (const ExitCode code = check_table_target("--csv", options_.csv, "query,map,", inputs, session_.common, session_.console); code != ExitCode::done) return code;
    if (const ExitCode code = setup_.check(); code != ExitCode::done) return code;
    if (const ExitCode code = read(); code != ExitCode::done) return code;
    evaluate();
    return write();
  }

 private:
  ExitCode read() {
    for (const std::string& folder : options_.folders) {
      session_.progress().at(0.1 * static_cast<double>(surveys_.size()) / static_cast<double>(options_.folders.size()), "Reading " + folder);
      auto inventory = setup_.read(folder);
      if (!inventory) return ExitCode::unusable_input;
      surveys_.push_back(std::move(*inventory));
    }
    return ExitCode::done;
  }

  void evaluate() {
    const double all = static_cast<double>(surveys_.size() * (surveys_.size() - 1));
    const treeloc::Settings settings = setup_.settings();
    for (const Inventory& map : surveys_) {
      const auto scenes = setup_.map_scenes(*map.frames, settings);
      for (const Inventory& query : surveys_) {
        if (&query == &map) continue;
        const double done = static_cast<double>(pairs_.size());
        const Progress progress = session_.progress().stage(0.1 + 0.9 * done / all, 0.1 + 0.9 * (done + 1.0) / all);
        PairResult pair;
        pair.about.mode = "inter";
        pair.about.method = options_.method.method;
        pair.about.map_mode = options_.method.map_mode;
        pair.about.query = query.name;
        pair.about.map = map.name;
        pair.evaluation = evaluate_inter(setup_.query_scenes(*query.frames, settings), scenes, setup_.regions(), settings, setup_.protocol(),
                                         session_.common.threads, progress);
        pair.about.threads = session_.common.threads > 0 ? session_.common.threads : hardware_threads();
        if (pair.evaluation.rows.empty())
          session_.console.warn(query.name + " in " + map.name + ": no query has a scene nearby: nothing to measure, the pair is in no mean");
        pairs_.push_back(std::move(pair));
      }
    }
  }

  ExitCode write() {
    session_.console.end_progress();
    Issues wrong;
    if (!options_.csv.empty()) wrong = write_result(options_.csv, pairs_csv(pairs_));
    for (const PairResult& pair : pairs_) {
      if (!options_.plots.empty() && !has_error(wrong))
        wrong = write_evaluation_plots(pair.evaluation, pair.about, options_.plots, pair.about.query + "_in_" + pair.about.map + "_");
    }
    session_.console.issues(wrong);
    if (has_error(wrong)) return ExitCode::failed;
    if (!session_.common.quiet && session_.common.json != "-") say();
    Json pairs = Json::array();
    bool anything = false;
    for (const PairResult& pair : pairs_) {
      pairs.push_back(Json::parse(evaluation_json(pair.evaluation, pair.about)));
      anything = anything || !pair.evaluation.rows.empty();
    }
    const Json json{{"mode", "pairs"}, {"method", options_.method.method}, {"pairs", pairs}, {"means", means_json(pairs_)},
                    {"threshold_transfer", transfer_json(pairs_, setup_.protocol().thresholds)}};
    const ExitCode written = session_.write_json(json.dump(2) + "\n");
    if (written == ExitCode::done && !anything) {
      session_.console.error("no query has a scene of another survey nearby: nothing to measure (are the trajectories in one frame?)");
      return ExitCode::failed;
    }
    return written;
  }

  void say() const {
    for (const PairResult& pair : pairs_) std::cout << evaluation_text(pair.evaluation, pair.about);
    for (const Figure& figure : figures) {
      const treeloc::Stability s = treeloc::stability_of(values_of(pairs_, figure));
      std::cout << figure.name << ": mean " << short_number(s.mean) << ", sd " << short_number(s.sd) << ", S " << short_number(s.stability) << "\n";
    }
    std::cout << std::flush;
  }

  const EvaluatePairsOptions& options_;
  Session& session_;
  EvaluateSetup setup_;
  std::vector<Inventory> surveys_;
  std::vector<PairResult> pairs_;
};

}  // namespace

ExitCode run_evaluate_pairs(const EvaluatePairsOptions& options, Session& session) { return PairsRun(options, session).run(); }

}  // namespace stemwise
