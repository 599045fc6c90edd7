#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands/evaluate.hpp"
#include "core/treeloc/paired_tests.hpp"
#include "io/read_query_rows.hpp"

namespace stemwise {
namespace {

using Json = nlohmann::ordered_json;
using treeloc::QueryRow;

std::vector<QueryRow> rows_from(const std::vector<QueryResult>& results) {
  std::vector<QueryRow> rows;
  for (const QueryResult& result : results) {
    QueryRow& row = rows.emplace_back();
    row.query = result.query;
    row.candidate = result.candidate;
    row.positive = result.positive;
    row.score = result.score;
    for (std::size_t i = 0; i < 3; ++i) {
      row.error.position_m[i] = result.position_m[i];
      row.error.angle_deg[i] = result.angle_deg[i];
    }
  }
  return rows;
}

Json mcnemar_json(const treeloc::McNemar& test) { return {{"only_a", test.only_a}, {"only_b", test.only_b}, {"p", test.p}}; }

Json wilcoxon_json(const treeloc::Wilcoxon& test) {
  return {{"pairs", test.pairs}, {"median_difference", test.median_difference}, {"rank_sum", test.rank_sum}, {"p", test.p}};
}

Json comparison_json(const treeloc::PairedComparison& c, const EvaluateCompareOptions& options, std::uint64_t seed) {
  Json differences;
  for (const treeloc::BootstrapDifference& d : c.differences)
    differences[d.figure] = {{"a", d.a}, {"b", d.b}, {"difference", d.difference}, {"ci95", {d.low, d.high}}};
  return {{"mode", "compare"},
          {"a", options.a},
          {"b", options.b},
          {"queries", c.queries},
          {"common_successes", c.common_successes},
          {"seed", seed},
          {"resamples", options.resamples},
          {"mcnemar",
           {{"recall_at_1", mcnemar_json(c.recall_at_1)},
            {"r50_3d", mcnemar_json(c.r50_3d)},
            {"sr_2d", mcnemar_json(c.sr_2d)},
            {"sr_3d", mcnemar_json(c.sr_3d)}}},
          {"wilcoxon", {{"position_m", wilcoxon_json(c.position_m)}, {"rotation_deg", wilcoxon_json(c.rotation_deg)}}},
          {"bootstrap", differences}};
}

std::string formatted(const char* format, double a, double b, double c) {
  char text[128];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

std::string comparison_text(const treeloc::PairedComparison& c) {
  std::string text = std::to_string(c.queries) + " queries in both\n";
  const auto say = [&](const char* name, const treeloc::McNemar& t) {
    text += std::string("  ") + name + ": only A " + std::to_string(t.only_a) + ", only B " + std::to_string(t.only_b) +
            formatted(", exact McNemar p %.3g", t.p, 0.0, 0.0) + "\n";
  };
  say("R@1", c.recall_at_1);
  say("R@50 3D", c.r50_3d);
  say("SR 2D", c.sr_2d);
  say("SR 3D", c.sr_3d);
  text += "  " + std::to_string(c.common_successes) + " common successes, A - B: " +
          formatted("position median %.4f m, Wilcoxon p %.3g", c.position_m.median_difference, c.position_m.p, 0.0) +
          formatted("; rotation %.4f deg, p %.3g\n", c.rotation_deg.median_difference, c.rotation_deg.p, 0.0);
  for (const treeloc::BootstrapDifference& d : c.differences)
    text += "  " + d.figure + formatted(": A - B %.4f (95 %% %.4f to %.4f)", d.difference, d.low, d.high) + "\n";
  return text;
}

}  // namespace

ExitCode run_evaluate_compare(const EvaluateCompareOptions& options, Session& session) {
  if (const ExitCode code = session.apply_settings({}); code != ExitCode::done) return code;
  const auto a = read_query_rows(options.a), b = read_query_rows(options.b);
  session.console.issues(a.issues);
  session.console.issues(b.issues);
  if (!a || !b) return ExitCode::unusable_input;
  const treeloc::PairedComparison compared =
      treeloc::compare_methods(rows_from(*a), rows_from(*b), {}, options.resamples, session.common.seed);
  if (compared.queries == 0) {
    session.console.error("the two files have no query in common");
    return ExitCode::failed;
  }
  session.console.end_progress();
  if (!session.common.quiet && session.common.json != "-") std::cout << comparison_text(compared) << std::flush;
  return session.write_json(comparison_json(compared, options, session.common.seed).dump(2) + "\n");
}

}  // namespace stemwise
