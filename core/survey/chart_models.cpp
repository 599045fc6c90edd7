#include "core/survey/chart_models.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stemwise {
namespace {

constexpr double cm_per_m = 100.0;

std::string fixed(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value));
  const bool is_zero = std::string(text).find_first_of("123456789") == std::string::npos;
  return value < 0.0 && !is_zero ? "\u2212" + std::string(text) : std::string(text);
}

std::string name_of(const ProjectState& state, InventoryId id) {
  const Inventory* inventory = state.find(id);
  return inventory ? inventory->name : "?";
}

/// "2018 to 2023".
std::string span_of(const ProjectState& state, InventoryId from, InventoryId to) { return name_of(state, from) + " to " + name_of(state, to); }

const GrowthRow* growth_row(const Tables& tables, InventoryId from, InventoryId to) {
  for (const GrowthRow& row : tables.growth)
    if (row.from == from && row.to == to) return &row;
  return nullptr;
}

std::vector<const MatchRow*> matches_between(const Tables& tables, InventoryId from, InventoryId to) {
  std::vector<const MatchRow*> rows;
  for (const MatchRow& row : tables.matches)
    if (row.state != MatchState::rejected && row.a.inventory == from && row.b.inventory == to) rows.push_back(&row);
  return rows;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// 1, 2, 2.5 or 5 times a power of ten, at least `rough`.
double bin_width(double rough) {
  if (!(rough > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (rough <= factor * power * (1.0 + 1e-9)) return factor * power;
  return 10.0 * power;
}

/// "5.0 to 10.0 cm"; a class that holds what lies beyond its outer edge as well names only the inner one.
std::string class_words(double low, double high, double width, bool is_open_low, bool is_open_high) {
  const int decimals = width < 1.0 ? 2 : 1;
  if (is_open_low) return "below " + fixed(high, decimals) + " cm";
  if (is_open_high) return fixed(low, decimals) + " cm and more";
  return fixed(low, decimals) + " to " + fixed(high, decimals) + " cm";
}

/// Counts values, cm, in bins of `width` from `low`; those beyond the ends go into the outermost bins.
std::vector<ChartBar> histogram(const std::vector<std::pair<double, TreeId>>& values, double low, double high, double width) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round((high - low) / width)));
  std::vector<ChartBar> bars(count);
  for (std::size_t i = 0; i < count; ++i) bars[i] = {low + width * static_cast<double>(i), low + width * static_cast<double>(i + 1), 0.0, {}, {}};
  bool is_open_low = false, is_open_high = false;
  for (const auto& [value, tree] : values) {
    const double at = std::floor((value - low) / width + 1e-9);
    ChartBar& bar = bars[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)))];
    is_open_low = is_open_low || at < 0.0;
    is_open_high = is_open_high || at > static_cast<double>(count - 1);
    bar.value += 1.0;
    bar.trees.push_back(tree);
  }
  for (ChartBar& bar : bars) bar.label = class_words(bar.x_low, bar.x_high, width, is_open_low && &bar == &bars.front(), is_open_high && &bar == &bars.back());
  return bars;
}

double tallest(const std::vector<ChartBars>& series) {
  double most = 0.0;
  for (const ChartBars& one : series)
    for (const ChartBar& bar : one.bars) most = std::max(most, bar.value);
  return most;
}

void fit_counts(ChartModel& chart) { chart.y = {"Stems", "", 0.0, std::max(1.0, 1.08 * tallest(chart.bars)), {}, {}}; }

/// Says that the outermost bars count more than their own class.
void note_open_ends(ChartModel& chart) {
  for (const ChartBars& series : chart.bars) {
    const bool is_low = series.bars.front().label.starts_with("below"), is_high = series.bars.back().label.ends_with("more");
    if (!is_low && !is_high) continue;
    chart.x.note = is_low && is_high ? "end bars count all beyond" : is_high ? "last bar counts all beyond" : "first bar counts all below";
    return;
  }
}

std::string stems_text(std::size_t n) { return std::to_string(n) + (n == 1 ? " stem" : " stems"); }

}  // namespace

ChartModel dbh_class_chart(const ProjectState& state, const Tables& tables, double class_width_m) {
  ChartModel chart;
  chart.title = "DBH classes";
  std::vector<double> all;
  for (const ObservationRow& row : tables.observations)
    if (row.dbh_m) all.push_back(*row.dbh_m * cm_per_m);
  if (all.empty()) {
    chart.empty_text = "No stem has a measured DBH yet.";
    return chart;
  }
  const double width = class_width_m * cm_per_m;
  const double high = std::max(width, std::ceil(percentile(all, 0.999) / width + 1e-9) * width);
  const double low = std::floor(*std::min_element(all.begin(), all.end()) / width) * width;
  const auto surveys = static_cast<double>(tables.inventories.size());
  for (std::size_t s = 0; s < tables.inventories.size(); ++s) {
    std::vector<std::pair<double, TreeId>> values;
    for (const ObservationRow& row : tables.observations)
      if (row.dbh_m && row.stem.inventory == tables.inventories[s]) values.emplace_back(*row.dbh_m * cm_per_m, row.tree);
    ChartBars bars{name_of(state, tables.inventories[s]), {ChartInk::survey, s}, histogram(values, low, high, width)};
    for (ChartBar& bar : bars.bars) {  // beside each other within the class
      const double share = 0.84 * width / surveys, left = bar.x_low + 0.08 * width + share * static_cast<double>(s);
      bar.x_low = left;
      bar.x_high = left + share;
    }
    chart.bars.push_back(std::move(bars));
  }
  chart.x = {"DBH", "cm", low, high, {}, {}};
  note_open_ends(chart);
  chart.note = "Classes of " + fixed(width, width == std::round(width) ? 0 : 1) + " cm";
  fit_counts(chart);
  return chart;
}

ChartModel growth_distribution_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to) {
  ChartModel chart;
  chart.title = "DBH change, " + span_of(state, from, to);
  std::vector<std::pair<double, TreeId>> values;
  std::vector<double> changes;
  for (const MatchRow* row : matches_between(tables, from, to))
    if (row->change_m) {
      values.emplace_back(*row->change_m * cm_per_m, row->tree);
      changes.push_back(*row->change_m * cm_per_m);
    }
  if (changes.empty()) {
    chart.empty_text = "No matched stem was measured in both surveys. Align the surveys first.";
    return chart;
  }
  const double q01 = percentile(changes, 0.01), q99 = percentile(changes, 0.99);
  const double width = bin_width(std::max(q99 - q01, 0.4) / 28.0);
  const double low = std::floor(std::min(q01, 0.0) / width) * width, high = std::max(std::ceil(q99 / width), std::floor(low / width) + 4.0) * width;
  chart.bars.push_back({"Stems", {ChartInk::accent, 0}, histogram(values, low, high, width)});
  chart.x = {"DBH change", "cm", low, high, {}, {}};
  fit_counts(chart);
  chart.rules.push_back({0.0, true, "", false});
  if (const GrowthRow* row = growth_row(tables, from, to)) {
    chart.bands.push_back({row->p20_p80_m[0] * cm_per_m, row->p20_p80_m[1] * cm_per_m, true, "20\u201380 %", {ChartInk::accent, 0}});
    const double median = row->median_change_m * cm_per_m;
    chart.rules.push_back({median, true, "median " + fixed(median, 1) + " cm", true});
    chart.note = stems_text(changes.size()) + ", median " + fixed(median, 1) + " cm (95 % interval " + fixed(row->ci95_m[0] * cm_per_m, 1) +
                 " to " + fixed(row->ci95_m[1] * cm_per_m, 1) + "), DBH error " + fixed(row->dbh_error_m * cm_per_m, 1) + " cm";
  }
  note_open_ends(chart);
  return chart;
}

ChartModel growth_against_dbh_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to) {
  ChartModel chart;
  chart.title = "DBH change against DBH, " + span_of(state, from, to);
  chart.points = {{"Within error", {ChartInk::within_error, 0}, {}, false}, {"Grew", {ChartInk::grew, 0}, {}, false}, {"Shrank", {ChartInk::shrank, 0}, {}, false}};
  std::vector<double> diameters, changes;
  for (const MatchRow* row : matches_between(tables, from, to)) {
    if (!row->change_m || !row->dbh_a_m) continue;
    const ChartPoint point{*row->dbh_a_m * cm_per_m, *row->change_m * cm_per_m, 0.0, row->tree};
    chart.points[row->change == ChangeClass::grew ? 1 : row->change == ChangeClass::shrank ? 2 : 0].points.push_back(point);
    diameters.push_back(point.x);
    changes.push_back(point.y);
  }
  if (changes.empty()) {
    chart.points.clear();
    chart.empty_text = "No matched stem was measured in both surveys. Align the surveys first.";
    return chart;
  }
  const double q01 = percentile(changes, 0.005), q99 = percentile(changes, 0.995), room = 0.12 * std::max(1.0, q99 - q01);
  chart.x = {"DBH " + name_of(state, from), "cm", std::max(0.0, percentile(diameters, 0.0) - 2.0), percentile(diameters, 0.999) + 2.0, {}, {}};
  chart.y = {"DBH change", "cm", std::min(q01, 0.0) - room, std::max(q99, 0.0) + room, {}, {}};
  chart.rules.push_back({0.0, false, "", false});
  if (const GrowthRow* row = growth_row(tables, from, to)) {
    const double error = 2.0 * std::sqrt(2.0) * row->dbh_error_m * cm_per_m;
    chart.bands.push_back({-error, error, false, "within error", {ChartInk::within_error, 0}});
  }
  chart.note = stems_text(changes.size()) + ", a dot per tree";
  return chart;
}

ChartModel dbh_over_time_chart(const ProjectState& state, const Tables& tables, TreeId tree) {
  ChartModel chart;
  chart.title = "DBH over time";
  ChartPoints line{tree_label(tree), {ChartInk::accent, 0}, {}, true};
  double low = 1e9, high = -1e9;
  const bool has_dates = std::all_of(tables.inventories.begin(), tables.inventories.end(), [&](InventoryId id) { return state.find(id) && state.find(id)->date; });
  for (std::size_t s = 0; s < tables.inventories.size(); ++s) {
    const Inventory* inventory = state.find(tables.inventories[s]);
    const double x = has_dates && inventory ? 1970.0 + inventory->date->days / 365.25 : static_cast<double>(s);
    chart.x.ticks.push_back(x);
    chart.x.tick_labels.push_back(has_dates && inventory ? std::to_string(year_of(*inventory->date)) : name_of(state, tables.inventories[s]));
  }
  for (const ObservationRow& row : tables.observations) {
    if (row.tree != tree || !row.dbh_m) continue;
    const auto at = std::find(tables.inventories.begin(), tables.inventories.end(), row.stem.inventory) - tables.inventories.begin();
    const double error = row.dbh_error_m.value_or(0.0) * cm_per_m, dbh = *row.dbh_m * cm_per_m;
    line.points.push_back({chart.x.ticks[static_cast<std::size_t>(at)], dbh, error, tree});
    low = std::min(low, dbh - error);
    high = std::max(high, dbh + error);
  }
  if (line.points.empty()) {
    chart.empty_text = "This tree has no measured DBH.";
    return chart;
  }
  std::sort(line.points.begin(), line.points.end(), [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; });
  const double room = std::max(0.5, 0.15 * (high - low));
  const double span = chart.x.ticks.back() - chart.x.ticks.front();
  chart.x.low = chart.x.ticks.front() - std::max(0.3, 0.08 * span);
  chart.x.high = chart.x.ticks.back() + std::max(0.3, 0.08 * span);
  chart.y = {"DBH", "cm", low - room, high + room, {}, {}};
  chart.points.push_back(std::move(line));
  return chart;
}

ChartModel residual_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to) {
  ChartModel chart;
  chart.title = "Distance between matched stems, " + span_of(state, from, to);
  std::vector<std::pair<double, TreeId>> values;
  std::vector<double> distances;
  double sum_sq = 0.0;
  for (const MatchRow* row : matches_between(tables, from, to)) {
    const double distance = row->distance_m * cm_per_m;
    values.emplace_back(distance, row->tree);
    distances.push_back(distance);
    sum_sq += distance * distance;
  }
  if (distances.empty()) {
    chart.empty_text = "No stems are matched yet. Align the surveys first.";
    return chart;
  }
  const double rms = std::sqrt(sum_sq / static_cast<double>(distances.size()));
  const double width = bin_width(std::max(percentile(distances, 0.99), 1.0) / 28.0);
  const double high = std::max(4.0, std::ceil(percentile(distances, 0.995) / width)) * width;
  chart.bars.push_back({"Stems", {ChartInk::accent, 0}, histogram(values, 0.0, high, width)});
  chart.x = {"Distance", "cm", 0.0, high, {}, {}};
  fit_counts(chart);
  chart.rules.push_back({rms, true, "RMS " + fixed(rms, 1) + " cm", true});
  chart.note = stems_text(distances.size()) + ", median " + fixed(percentile(distances, 0.5), 1) + " cm";
  note_open_ends(chart);
  return chart;
}

std::vector<ChartModel> report_charts(const ProjectState& state, const Tables& tables) {
  std::vector<ChartModel> charts{dbh_class_chart(state, tables)};
  for (std::size_t i = 1; i < tables.inventories.size(); ++i) {
    const InventoryId from = tables.inventories[i - 1], to = tables.inventories[i];
    charts.push_back(growth_distribution_chart(state, tables, from, to));
    charts.push_back(growth_against_dbh_chart(state, tables, from, to));
    charts.push_back(residual_chart(state, tables, from, to));
  }
  std::erase_if(charts, [](const ChartModel& chart) { return !chart.empty_text.empty(); });
  return charts;
}

}  // namespace stemwise
