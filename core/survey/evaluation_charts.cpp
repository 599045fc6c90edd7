#include "core/survey/evaluation_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/quantile.hpp"
#include "core/treeloc/session_pairs.hpp"

namespace stemwise {
namespace {

using treeloc::Evaluation;
using treeloc::QueryRow;

ChartModel empty_chart(const std::string& title) {
  ChartModel chart;
  chart.title = title;
  chart.empty_text = "No query has a scene of the map near it: there is nothing to draw.";
  return chart;
}

/// The rows whose errors count: against the truth moved by the fitted transform where there is one.
const std::vector<QueryRow>& measured_rows(const Evaluation& evaluation) {
  return evaluation.truth_aligned_rows.empty() ? evaluation.rows : evaluation.truth_aligned_rows;
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", value);
  return text;
}

ChartBox box_of(double x, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double q) { return quantile_of_sorted(values, q); };
  return {x, 0.5, at(0.05), at(0.25), at(0.5), at(0.75), at(0.95), {}};
}

/// Three boxes side by side.
ChartModel error_boxes(const Evaluation& evaluation, const std::string& title, bool of_position) {
  std::array<std::vector<double>, 3> errors;
  for (const QueryRow& row : measured_rows(evaluation)) {
    if (!row.found() || !row.positive || row.error.spatial_m() > 1.0) continue;
    for (std::size_t i = 0; i < 3; ++i)
      errors[i].push_back(std::abs(of_position ? row.error.position_m[i] : row.error.angle_deg[i]));
  }
  if (errors[0].empty()) return empty_chart(title);
  ChartModel chart;
  chart.title = title;
  chart.note = std::to_string(errors[0].size()) + " poses; boxes: quartiles and median, whiskers: 5 to 95 %";
  chart.x = {"", "", 0.4, 3.6, {1.0, 2.0, 3.0}, {"x", "y", "z"}};
  if (!of_position) chart.x.tick_labels = {"roll", "pitch", "yaw"};
  chart.y = {of_position ? "position error" : "rotation error", of_position ? "m" : "deg", 0.0, 0.0, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    chart.boxes.push_back(box_of(static_cast<double>(i) + 1.0, errors[i]));
    chart.y.high = std::max(chart.y.high, 1.08 * chart.boxes.back().whisker_high);
  }
  return chart;
}

}  // namespace

ChartModel precision_recall_chart(const Evaluation& evaluation, const std::string& title) {
  if (evaluation.rows.empty()) return empty_chart(title);
  constexpr int thresholds = 400;
  ChartModel chart;
  chart.title = title;
  ChartPoints curve{"sweep of thresholds", {}, {}, true, false};
  double lowest = 1.0;
  for (int k = thresholds; k >= 0; --k) {
    const treeloc::AtThreshold at = treeloc::at_threshold(evaluation.rows, static_cast<double>(k) / thresholds);
    if (at.accepted == 0) continue;
    curve.points.push_back({at.recall, at.precision, 0.0, {}});
    lowest = std::min(lowest, at.precision);
  }
  const treeloc::AtThreshold fixed = treeloc::at_threshold(evaluation.rows, evaluation.acceptance_score);
  chart.points.push_back(std::move(curve));
  chart.points.push_back({"fixed threshold of the method", {ChartInk::warning, 0}, {{fixed.recall, fixed.precision, 0.0, {}}}, true, true});
  chart.x = {"recall", "share", 0.0, 1.0, {}, {}};
  chart.y = {"precision", "share", std::min(0.9, 0.1 * std::floor(10.0 * lowest)), 1.01, {}, {}};
  return chart;
}

ChartModel position_error_chart(const Evaluation& evaluation, const std::string& title) { return error_boxes(evaluation, title, true); }

ChartModel rotation_error_chart(const Evaluation& evaluation, const std::string& title) { return error_boxes(evaluation, title, false); }

ChartModel query_time_chart(const Evaluation& evaluation, const std::string& title) {
  if (evaluation.rows.empty()) return empty_chart(title);
  ChartModel chart;
  chart.title = title;
  ChartPoints times{"retrieval to pose", {}, {}, false, true};
  std::vector<double> sorted;
  for (const QueryRow& row : evaluation.rows) {
    times.points.push_back({static_cast<double>(times.points.size()) + 1.0, 1e3 * row.query_s, 0.0, {}});
    sorted.push_back(1e3 * row.query_s);
  }
  std::sort(sorted.begin(), sorted.end());
  chart.x = {"query", "", 0.0, static_cast<double>(sorted.size()) + 1.0, {}, {}};
  chart.y = {"time", "ms", 0.0, 1.08 * std::max(0.1, quantile_of_sorted(sorted, 0.995)), {}, {}};
  chart.note = "median " + milliseconds(quantile_of_sorted(sorted, 0.5)) + " (the line), 99 % within " +
               milliseconds(quantile_of_sorted(sorted, 0.99));
  chart.rules.push_back({quantile_of_sorted(sorted, 0.5), false, "", true});
  chart.points.push_back(std::move(times));
  return chart;
}

}  // namespace stemwise
