#include "io/preview_inventory.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/delimited_text.hpp"
#include "io/open_table.hpp"
#include "io/plot_filter.hpp"
#include "io/project_file.hpp"
#include "io/stem_columns.hpp"
#include "io/status_code.hpp"
#include "io/stems_from_table.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

using K = ColumnKind;

constexpr std::size_t rows_shown = 40;
constexpr std::size_t most_codes = 24;
constexpr std::size_t most_plots = 500;

void show_rows(const StemTable& table, InventoryPreview& preview) {
  preview.header = table.header;
  preview.row_count = static_cast<std::int64_t>(table.rows.size());
  for (std::size_t r = 0; r < std::min(rows_shown, table.rows.size()); ++r) {
    preview.row_numbers.push_back(table.rows[r].row);
    preview.rows.push_back(table.rows[r].cells);
  }
}

void show_plots(const StemTable& table, const ReadOptions& options, InventoryPreview& preview) {
  for (const std::size_t c : plot_columns_with_several_values(table)) preview.plot_columns.push_back(table.header[c]);
  std::optional<std::size_t> column = options.plot_column.empty() ? std::nullopt : table.find(options.plot_column);
  if (!column && !preview.plot_columns.empty()) column = table.find(preview.plot_columns.front());
  if (!column) return;
  preview.plot_column = table.header[*column];
  for (const GridRow& row : table.rows) {
    const std::string value(table.cell(row, *column));
    if (value.empty() || std::find(preview.plots.begin(), preview.plots.end(), value) != preview.plots.end()) continue;
    preview.plots.push_back(value);
    if (preview.plots.size() == most_plots) break;
  }
}

/// The two columns of the position, by our names of them.
std::vector<std::pair<K, std::size_t>> position_kinds(const PositionColumns& position) {
  switch (position.scheme) {
    case PositionScheme::cartesian: return {{K::x, position.first}, {K::y, position.second}};
    case PositionScheme::geographic: return {{K::lon, position.first}, {K::lat, position.second}};
    case PositionScheme::polar: return {{K::azimuth, position.first}, {K::distance, position.second}};
    case PositionScheme::quadrat: return {{K::local_x, position.first}, {K::local_y, position.second}, {K::quadrat, position.quadrat}};
  }
  return {};
}

void show_columns(const StemTable& table, const StemColumns& columns, InventoryPreview& preview) {
  std::vector<std::pair<K, std::size_t>> used = position_kinds(columns.position);
  for (const K kind : {K::z, K::dbh, K::circumference, K::dbh_approximation, K::height, K::id, K::species, K::status, K::date}) {
    if (const auto at = columns[kind]) used.emplace_back(kind, *at);
  }
  for (const auto& [kind, at] : used) {
    ColumnPreview column{to_string(kind), table.header[at], "", "", false};
    const auto unit = std::find_if(columns.units.begin(), columns.units.end(), [k = kind](const UnitChoice& u) { return u.kind == k; });
    if (unit != columns.units.end()) {
      column.unit = unit->unit;
      column.how = unit->how;
      column.guessed = unit->guessed;
    }
    preview.columns.push_back(std::move(column));
  }
}

void show_status_codes(const StemTable& table, const StemColumns& columns, const ReadOptions& options, InventoryPreview& preview) {
  const auto at = columns[K::status];
  if (!at) return;
  std::map<std::string, std::int64_t> counts;
  for (const GridRow& row : table.rows) {
    if (const auto code = table.cell(row, *at); !code.empty()) ++counts[std::string(code)];
  }
  const bool from_one = table.names[*at].base == "statuscd";
  for (const auto& [code, rows] : counts) {
    const auto told = options.status_codes.find(code);
    preview.status_codes.push_back({code, rows, told != options.status_codes.end() ? told->second : status_from_code(code, from_one)});
  }
  std::stable_sort(preview.status_codes.begin(), preview.status_codes.end(), [from_one](const auto& a, const auto& b) {  // by the words themselves: a row stays where it is when someone says what it means
    const bool a_is_asked = status_from_code(a.code, from_one) == StemStatus::unknown, b_is_asked = status_from_code(b.code, from_one) == StemStatus::unknown;
    return a_is_asked != b_is_asked ? a_is_asked : a.rows > b.rows;
  });
  if (preview.status_codes.size() > most_codes) preview.status_codes.resize(most_codes);
}

/// Text whose header is not recognised: its first line, cut where that gives most fields.
void show_first_line_as_header(const std::string& path, InventoryPreview& preview) {
  const auto file = read_text_file(path);
  if (!file) return;
  Grid best;
  for (const char delimiter : {',', ';', '\t', '|', ' '}) {
    Grid grid = parse_delimited(file->text, delimiter, rows_shown + 1);
    if (!grid.rows.empty() && (best.rows.empty() || grid.rows[0].cells.size() > best.rows[0].cells.size())) best = std::move(grid);
  }
  if (best.rows.empty() || best.rows[0].cells.size() < 2) return;
  preview.header = best.rows[0].cells;
  for (std::size_t r = 1; r < best.rows.size(); ++r) {
    preview.row_numbers.push_back(best.rows[r].row);
    preview.rows.push_back(best.rows[r].cells);
  }
}

void show_table(OpenedTable opened, const ReadOptions& options, InventoryPreview& preview) {
  preview.format = opened.format;
  preview.sheets = opened.sheets;
  for (const std::string& note : opened.table.notes) {
    for (const std::string word : {"sheet: ", "layer: "}) {
      if (note.starts_with(word)) preview.sheet = note.substr(word.size());
    }
  }
  show_plots(opened.table, options, preview);
  StemTable table = opened.table;
  if (!keep_one_plot(table, options)) table = opened.table;  // the failure is said by reading
  show_rows(table, preview);
  if (const auto columns = recognise_columns(table, options)) {
    show_columns(table, *columns, preview);
    show_status_codes(table, *columns, options, preview);
  }
  preview.inventory = inventory_from_table(std::move(opened), options);
}

}  // namespace

InventoryPreview preview_inventory(const std::string& path, const ReadOptions& options) {
  InventoryPreview preview;
  preview.path = path;
  std::error_code error;
  const bool file = std::filesystem::is_regular_file(path, error) && !is_project(path);
  auto opened = file ? open_table(path, options) : std::nullopt;
  if (opened && *opened) {
    show_table(std::move(**opened), options, preview);
    return preview;
  }
  preview.inventory = read_inventory(path, options);
  if (preview.inventory) preview.format = preview.inventory->source.format;
  if (opened && !preview.inventory) show_first_line_as_header(path, preview);
  return preview;
}

}  // namespace stemwise
