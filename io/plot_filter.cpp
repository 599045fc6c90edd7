#include "io/plot_filter.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "io/parse_decimal.hpp"

namespace stemwise {
namespace {

constexpr std::size_t values_named = 12;

bool same_value(std::string_view cell, const std::string& wanted) {
  if (cell == wanted) return true;
  const auto a = parse_decimal(cell);
  const auto b = parse_decimal(wanted);
  return a && b && *a == *b;
}

std::vector<std::string> distinct_values(const StemTable& table, std::size_t column) {
  std::vector<std::string> values;
  std::map<std::string_view, bool> seen;
  for (const GridRow& row : table.rows) {
    const std::string_view value = table.cell(row, column);
    if (!value.empty() && seen.emplace(value, true).second) values.emplace_back(value);
  }
  return values;
}

std::string list(const std::vector<std::string>& values) {
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), values_named); ++i) text += (i > 0 ? ", " : "") + values[i];
  if (values.size() > values_named) text += ", ... (" + std::to_string(values.size()) + " in all)";
  return text;
}

Result<Done> refused(const StemTable& table, const std::string& column, std::string text, std::string help) {
  return Result<Done>::failure(Issue{Severity::error, table.file, 0, column, std::move(text), std::move(help)});
}

std::vector<std::size_t> plot_columns(const StemTable& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (name_rank(table.names[i], ColumnKind::plot)) columns.push_back(i);
  }
  return columns;
}

struct Box {
  std::array<double, 4> side{1e300, 1e300, -1e300, -1e300};
  std::size_t count = 0;
  void add(double x, double y) {
    side = {std::min(side[0], x), std::min(side[1], y), std::max(side[2], x), std::max(side[3], y)};
    ++count;
  }
  bool overlaps(const Box& o) const {  // by more than a quarter of the smaller box's sides
    const double w = std::min(side[2], o.side[2]) - std::max(side[0], o.side[0]);
    const double h = std::min(side[3], o.side[3]) - std::max(side[1], o.side[1]);
    return w > 0.25 * std::min(side[2] - side[0], o.side[2] - o.side[0]) && h > 0.25 * std::min(side[3] - side[1], o.side[3] - o.side[1]);
  }
};

}  // namespace

std::vector<std::size_t> plot_columns_with_several_values(const StemTable& table) {
  std::vector<std::size_t> several;
  for (const std::size_t column : plot_columns(table)) {
    const std::size_t values = distinct_values(table, column).size();
    if (values > 1 && values <= table.rows.size() / 2) several.push_back(column);
  }
  return several;
}

PlotGroups plot_groups(const StemTable& table) {
  PlotGroups groups;
  groups.group_of_row.assign(table.rows.size(), 0);
  const auto columns = plot_columns_with_several_values(table);
  if (columns.empty()) return groups;
  groups.column = columns.front();
  groups.values = distinct_values(table, columns.front());
  std::map<std::string_view, std::size_t> index;
  for (std::size_t i = 0; i < groups.values.size(); ++i) index[groups.values[i]] = i;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto it = index.find(table.cell(table.rows[r], columns.front()));
    if (it != index.end()) groups.group_of_row[r] = it->second;
  }
  return groups;
}

Result<Done> keep_one_plot(StemTable& table, const ReadOptions& options) {
  if (options.plot.empty() && options.plot_column.empty()) return Done{};
  std::vector<std::size_t> columns;
  if (!options.plot_column.empty()) {
    const auto column = table.find(options.plot_column);
    if (!column) return refused(table, options.plot_column, "there is no such column for --plot-column", "");
    columns = {*column};
  } else {
    columns = plot_columns(table);
    if (columns.empty()) return refused(table, {}, "no column tells plots apart", "name it with --plot-column");
  }
  for (const std::size_t column : columns) {
    const auto values = distinct_values(table, column);
    if (options.plot.empty()) {
      if (values.size() <= 1) return Done{};
      return refused(table, table.header[column], "holds several plots: " + list(values), "choose one with --plot VALUE");
    }
    if (std::none_of(values.begin(), values.end(), [&](const std::string& v) { return same_value(v, options.plot); })) continue;
    const auto other = [&](const GridRow& row) { return !same_value(table.cell(row, column), options.plot); };
    table.rows.erase(std::remove_if(table.rows.begin(), table.rows.end(), other), table.rows.end());
    table.notes.push_back("plot: " + table.header[column] + " = " + options.plot + ", " + std::to_string(table.rows.size()) + " rows");
    return Done{};
  }
  return refused(table, table.header[columns.front()], "there is no plot " + options.plot + "; there are " + list(distinct_values(table, columns.front())), "");
}

Issues warn_of_overlapping_plots(const StemTable& table, std::span<const std::size_t> rows, std::span<const double> x_m,
                                 std::span<const double> y_m, bool own_centres) {
  const PlotGroups groups = plot_groups(table);
  if (!groups.column || groups.values.size() < 2) return {};
  std::vector<Box> boxes(groups.values.size());
  for (std::size_t i = 0; i < rows.size(); ++i) boxes[groups.group_of_row[rows[i]]].add(x_m[i], y_m[i]);
  std::size_t pairs = 0;
  std::size_t overlapping = 0;
  const std::size_t tested = std::min<std::size_t>(boxes.size(), 200);
  for (std::size_t a = 0; a < tested; ++a) {
    for (std::size_t b = a + 1; b < tested; ++b) {
      if (boxes[a].count < 3 || boxes[b].count < 3) continue;
      ++pairs;
      overlapping += boxes[a].overlaps(boxes[b]) ? 1 : 0;
    }
  }
  if (!own_centres && (pairs == 0 || 2 * overlapping < pairs)) return {};
  return {{Severity::warning, table.file, 0, table.header[*groups.column],
           "holds " + std::to_string(groups.values.size()) + " plots with coordinates of their own, which lie on top of each other: " + list(groups.values),
           "read one at a time with --plot-column \"" + table.header[*groups.column] + "\" --plot \"" + groups.values.front() + "\""}};
}

}  // namespace stemwise
