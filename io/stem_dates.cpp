#include "io/stem_dates.hpp"

#include <algorithm>

#include "io/inventory_date.hpp"

namespace stemwise {
namespace {

using K = ColumnKind;

constexpr std::size_t cells_tried = 200;

/// The named date columns with something in them, best name first.
std::vector<std::size_t> named_date_columns(const StemTable& table) {
  std::vector<std::pair<int, std::size_t>> ranked;
  for (std::size_t i = 0; i < table.names.size(); ++i)
    if (const auto rank = name_rank(table.names[i], K::date)) ranked.emplace_back(*rank, i);
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::size_t> columns;
  for (const auto& [rank, i] : ranked) columns.push_back(i);
  return columns;
}

bool holds_dates(const StemTable& table, std::size_t column) {
  const DateReading reading = date_reading_of(table, column);
  std::size_t filled = 0, dates = 0;
  for (const GridRow& row : table.rows) {
    const auto cell = table.cell(row, column);
    if (is_missing_mark(cell)) continue;
    dates += reading(cell) ? 1 : 0;
    if (++filled == cells_tried) break;
  }
  return dates > 0 && 2 * dates >= filled;
}

std::string first_filled(const StemTable& table, std::size_t column) {
  for (const GridRow& row : table.rows)
    if (const auto cell = table.cell(row, column); !is_missing_mark(cell)) return std::string(cell.substr(0, 40));
  return {};
}

}  // namespace

std::optional<Date> DateReading::operator()(std::string_view cell) const {
  if (const auto date = date_from_text(cell, order)) return date;
  return serials ? date_from_serial(cell) : std::nullopt;
}

std::string DateReading::in_words() const {
  if (order == DayOrder::unknown) return serials ? ", a spreadsheet's count of days" : "";
  return (order == DayOrder::day_first ? ", day before month (told by " : ", month before day (told by ") + told_by + ")";
}

DateReading date_reading_of(const StemTable& table, std::size_t column) {
  DateReading reading;
  bool contradicted = false;
  std::size_t filled = 0, dates = 0, serials = 0;
  for (const GridRow& row : table.rows) {
    const auto cell = table.cell(row, column);
    if (is_missing_mark(cell)) continue;
    ++filled;
    if (date_from_serial(cell)) ++serials;
    else if (date_from_text(cell)) ++dates;
    const DayOrder told = order_told_by(cell);
    if (told == DayOrder::unknown) continue;
    contradicted = contradicted || (reading.order != DayOrder::unknown && reading.order != told);
    if (reading.order == DayOrder::unknown) reading.told_by = cell;
    reading.order = told;
  }
  if (contradicted) reading = {};
  reading.serials = serials > 0 && (dates > 0 || 20 * serials >= 19 * filled);  // among dates a number of that size is one
  return reading;
}

std::string why_no_date(std::string_view cell) {
  return date_from_text(cell, DayOrder::day_first) ? "may begin with the day or with the month, and no row tells which" : "is no date that can be read";
}

std::optional<std::size_t> choose_date_column(const StemTable& table) {
  for (const std::size_t column : named_date_columns(table))
    if (holds_dates(table, column)) return column;
  return std::nullopt;
}

Issues warn_of_unread_dates(const StemTable& table, const StemColumns& columns, const ReadOptions& options) {
  if (columns[K::date] || options.date || options.columns.contains("date")) return {};
  for (const std::size_t column : named_date_columns(table)) {
    const std::string cell = first_filled(table, column);
    if (cell.empty()) continue;
    return {{Severity::warning, table.file, 0, table.header[column], "\"" + cell + "\" " + why_no_date(cell) + "; no date was taken from this column", "tell the day of the survey with --date 2023-05-04"}};
  }
  return {};
}

void set_dates(Inventory& inventory, const StemTable& table, const StemColumns& columns, const ReadOptions& options) {
  std::vector<Date> dates;
  for (const Stem& s : inventory.stems) {
    if (s.date) dates.push_back(*s.date);
  }
  auto& notes = inventory.source.notes;
  inventory.date = median_date(dates);
  if (inventory.date) notes.push_back("date: " + to_string(*inventory.date) + ", median of " + std::to_string(dates.size()) + " stems");
  if (!inventory.date && columns.census_year) {
    inventory.date = date_from_civil(*columns.census_year, 7, 1);
    notes.push_back("date: " + std::to_string(*columns.census_year) + ", by the header");
  }
  if (!inventory.date) {
    inventory.date = date_from_name(table.file);
    if (inventory.date) notes.push_back("date: " + to_string(*inventory.date) + ", from the name");
  }
  if (options.date) {
    inventory.date = options.date;
    for (Stem& s : inventory.stems) s.date.reset();
    notes.push_back("date: " + to_string(*options.date) + ", as told");
  }
}

}  // namespace stemwise
