#include "io/stems_from_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>

#include "io/crs.hpp"
#include "io/inventory_date.hpp"
#include "io/plot_filter.hpp"
#include "io/project_degrees.hpp"
#include "io/repeated_stems.hpp"
#include "io/status_code.hpp"
#include "io/stem_columns.hpp"
#include "io/stem_dates.hpp"

namespace stemwise {
namespace {

std::string one_decimal(double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

using K = ColumnKind;

constexpr double largest_dbh_m = 20.0;      // the widest trunk ever measured has 14 m
constexpr double largest_position_m = 2e7;  // half the earth's girth
constexpr double quadrat_m = 20.0;

/// Turns rows into stems and gathers what is wrong with them.
class StemMaker {
 public:
  StemMaker(const StemTable& table, const StemColumns& columns, const ReadOptions& options) : table_(table), columns_(columns), options_(options) {
    if (const auto at = columns[K::status]) numbers_from_one_ = table.names[*at].base == "statuscd";
    if (const auto at = columns[K::date]) dates_ = date_reading_of(table, *at);
  }

  void run() {
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const GridRow& row = table_.rows[r];
      if (is_empty(row)) continue;
      ++rows_met_;
      const std::size_t issues_before = issues_.size();
      bad_ = false;
      Stem stem = stem_of(row);
      if (bad_) {
        for (std::size_t k = issues_before; k < issues_.size(); ++k) issues_[k].text += "; the row is left out";
        ++rows_bad_;
        continue;
      }
      if (stem.status == StemStatus::missing) {
        issues_.resize(issues_before);
        ++rows_missing_;
        continue;
      }
      if (!is_living(stem.status)) {
        issues_.resize(issues_before);  // nobody minds a dead tree's missing diameter
      } else if (columns_.several_censuses && !stem.dbh_m) {
        ++rows_absent_;
        continue;
      }
      stems_.push_back(std::move(stem));
      rows_.push_back(r);
    }
  }

  /// The NaNs: each named when they are few; a pipeline that writes NaN for everything it could not measure gets one line.
  Issues not_a_number_issues() const {
    if (without_number_.size() <= std::max<std::size_t>(20, rows_met_ / 50)) return without_number_;
    Issue one = without_number_.front();
    one.text = "and " + std::to_string(without_number_.size() - 1) + " more rows: " + one.text;
    return {one};
  }

  std::vector<Stem> stems_;
  std::vector<std::size_t> rows_;  ///< table row of each stem
  Issues issues_;
  std::size_t rows_met_ = 0, rows_bad_ = 0, rows_absent_ = 0, rows_missing_ = 0;
  std::map<std::string, std::size_t> unknown_codes_;  ///< of the status column, and how many rows have each
  Issues without_number_;  ///< NaN where a measurement may be missing

 private:
  void complain(const GridRow& row, std::size_t column, std::string text) {
    issues_.push_back({Severity::warning, table_.file, row.row, column < table_.header.size() ? table_.header[column] : std::string(), std::move(text), {}});
  }

  std::string shown(std::string_view cell) const { return "\"" + std::string(cell.substr(0, 40)) + "\""; }

  /// No cell of a column in use holds anything: a row of another table beside ours, or an empty one.
  bool is_empty(const GridRow& row) const {
    const auto filled = [&](std::size_t column) { return !table_.cell(row, column).empty(); };
    if (table_.cell(row, columns_.position.first) == table_.header[columns_.position.first]) return true;  // the header once more
    if (filled(columns_.position.first) || filled(columns_.position.second)) return false;
    for (const K kind : {K::dbh, K::circumference, K::id}) {
      if (columns_[kind] && filled(*columns_[kind])) return false;
    }
    return true;
  }

  /// A number that must be there.
  std::optional<double> needed(const GridRow& row, std::size_t column, const char* what) {
    const auto cell = table_.cell(row, column);
    const Quantity q = parse_quantity(cell, table_.style);
    if (q.kind == Quantity::Kind::number) return q.value;
    bad_ = true;
    if (column >= row.cells.size()) {
      complain(row, row.cells.size(), "the row has " + std::to_string(row.cells.size()) + " fields, " + std::to_string(table_.header.size()) + " expected");
    } else {
      complain(row, column, (cell.empty() ? std::string("is empty") : shown(cell)) + ", expected " + what);
    }
    return std::nullopt;
  }

  /// A number that may be missing; text in its place makes the row bad. `unit_m`: metres per unit.
  std::optional<double> optional_number(const GridRow& row, std::optional<std::size_t> column, double unit_m, const char* what) {
    if (!column) return std::nullopt;
    const auto cell = table_.cell(row, *column);
    const Quantity q = parse_quantity(cell, table_.style);
    if (q.kind == Quantity::Kind::number) return q.value * (metres_per(q.unit) > 0.0 ? metres_per(q.unit) : unit_m);
    if (q.kind == Quantity::Kind::bad) {
      bad_ = true;
      complain(row, *column, shown(cell) + ", expected " + what);
    } else if (q.kind == Quantity::Kind::not_a_number) {
      without_number_.push_back({Severity::warning, table_.file, row.row, table_.header[*column], shown(cell) + ", expected " + what + "; taken as not measured", {}});
    }
    return std::nullopt;
  }

  void set_position(const GridRow& row, Stem& stem) {
    const auto& p = columns_.position;
    const bool polar = p.scheme == PositionScheme::polar;
    const bool geographic = p.scheme == PositionScheme::geographic;
    const auto a = needed(row, p.first, polar ? "an azimuth" : geographic ? "a longitude in degrees" : "a number");
    const auto b = needed(row, p.second, polar ? "a distance" : geographic ? "a latitude in degrees" : "a number");
    if (!a || !b) return;
    stem.x_m = *a * columns_.position_m;
    stem.y_m = *b * columns_.position_m;
    if (polar) set_polar(row, *a, *b, stem);
    if (geographic && (std::abs(*a) > 180.0 || std::abs(*b) > 90.0)) {
      bad_ = true;
      complain(row, p.first, shown(table_.cell(row, p.first)) + " and " + shown(table_.cell(row, p.second)) + " are no longitude and latitude");
    }
    if (p.scheme == PositionScheme::quadrat) add_quadrat(row, stem);
    if (std::abs(stem.x_m) > largest_position_m || std::abs(stem.y_m) > largest_position_m) {
      bad_ = true;
      complain(row, p.first, shown(table_.cell(row, p.first)) + " and " + shown(table_.cell(row, p.second)) + " lie off the earth");
    }
  }

  void set_polar(const GridRow& row, double azimuth, double distance, Stem& stem) {
    const auto& p = columns_.position;
    if (azimuth < 0.0 || azimuth * columns_.azimuth_rad > 2.0 * 3.15) {
      bad_ = true;
      complain(row, p.first, shown(table_.cell(row, p.first)) + ", expected an azimuth of a full circle");
    } else if (distance < 0.0) {
      bad_ = true;
      complain(row, p.second, shown(table_.cell(row, p.second)) + ", expected a distance of 0 or more");
    }
    const double angle_rad = azimuth * columns_.azimuth_rad;  // clockwise from north (+y)
    const double distance_m = distance * columns_.position_m;
    stem.x_m = distance_m * std::sin(angle_rad);
    stem.y_m = distance_m * std::cos(angle_rad);
  }

  /// ForestGEO names a quadrat by column and row, two digits each, from 01 (or 00).
  void add_quadrat(const GridRow& row, Stem& stem) {
    const auto name = table_.cell(row, columns_.position.quadrat);
    const Quantity q = parse_quantity(name, table_.style);
    if (q.kind != Quantity::Kind::number || q.value < 0.0 || q.value > 9999.0) {
      bad_ = true;
      return complain(row, columns_.position.quadrat, shown(name) + ", expected a quadrat such as 0104");
    }
    const int number = static_cast<int>(q.value);
    stem.x_m += quadrat_m * std::max(number / 100 - 1, 0);
    stem.y_m += quadrat_m * std::max(number % 100 - 1, 0);
  }

  void set_diameter(const GridRow& row, Stem& stem) {
    const auto column = columns_[K::dbh] ? columns_[K::dbh] : columns_[K::circumference];
    if (!column) return;
    if (*column >= row.cells.size() && row.cells.size() < table_.header.size()) {
      bad_ = true;
      return complain(row, *column, "the row has " + std::to_string(row.cells.size()) + " fields, " + std::to_string(table_.header.size()) + " expected");
    }
    const double pi = 3.14159265358979323846;
    auto dbh = optional_number(row, column, columns_[K::dbh] ? columns_.dbh_m : columns_.dbh_m * pi, "a diameter");
    if (dbh && !columns_[K::dbh]) *dbh /= pi;
    if (dbh && *dbh > largest_dbh_m) {
      bad_ = true;
      complain(row, *column, shown(table_.cell(row, *column)) + " is " + one_decimal(*dbh) + " m, expected a tree's diameter");
    } else if (dbh && *dbh < 0.0) {
      complain(row, *column, shown(table_.cell(row, *column)) + ", expected a diameter above 0; taken as not measured");
    } else if (dbh && *dbh > 0.0) {
      stem.dbh_m = dbh;
    }
    if (const auto hint = optional_number(row, columns_[K::dbh_approximation], columns_.dbh_approximation_m, "a diameter"); hint && *hint > 0.0) {
      stem.dbh_approximation_m = hint;
    }
  }

  void set_axis(const GridRow& row, Stem& stem) {
    if (!columns_[K::axis_x] || !columns_[K::axis_y] || !columns_[K::axis_z]) return;
    const auto x = optional_number(row, columns_[K::axis_x], 1.0, "a number");
    const auto y = optional_number(row, columns_[K::axis_y], 1.0, "a number");
    const auto z = optional_number(row, columns_[K::axis_z], 1.0, "a number");
    if (!x || !y || !z) return;
    Eigen::Vector3d axis(*x, *y, *z);
    const double length = axis.norm();
    if (length < 1e-6) return;
    if (std::abs(length - 1.0) > 1e-12) axis /= length;  // what is a unit vector already stays as it is
    stem.axis = axis.z() < 0.0 ? Eigen::Vector3d(-axis) : axis;
  }

  void set_words(const GridRow& row, Stem& stem) {
    const auto text = [&](std::optional<std::size_t> column) { return column ? table_.cell(row, *column) : std::string_view(); };
    stem.source_id = std::string(text(columns_[K::id]));
    if (columns_.tag) stem.source_id = std::string(text(columns_.tag)) + "-" + std::string(text(columns_.stem_tag));
    if (stem.source_id.empty() || stem.source_id == "-") stem.source_id = std::to_string(row.row);
    if (const auto species = text(columns_[K::species]); !is_missing_mark(species)) {
      const auto genus = text(columns_.genus);
      stem.species = (genus.empty() ? std::string() : std::string(genus) + " ") + std::string(species);
    }
    if (const auto status = text(columns_[K::status]); !status.empty()) {
      const auto told = options_.status_codes.find(std::string(status));
      stem.status = told != options_.status_codes.end() ? told->second : status_from_code(status, numbers_from_one_);
      if (stem.status == StemStatus::unknown && told == options_.status_codes.end() && !is_missing_mark(status)) ++unknown_codes_[std::string(status)];
    }
    if (const auto date = text(columns_[K::date]); !is_missing_mark(date)) {
      stem.date = dates_(date);
      if (!stem.date) complain(row, *columns_[K::date], shown(date) + " " + why_no_date(date) + " (2023-05-04 can); left out");
    }
  }

  void set_quality(const GridRow& row, Stem& stem) {
    const auto number = [&](K kind) {
      const Quantity q = columns_[kind] ? parse_quantity(table_.cell(row, *columns_[kind]), table_.style) : Quantity{};
      return q.kind == Quantity::Kind::number ? std::optional(q.value) : std::nullopt;
    };
    if (const auto clusters = number(K::number_clusters); clusters && *clusters >= 0 && *clusters < 1e6) stem.number_clusters = static_cast<int>(*clusters);
    if (const auto score = number(K::score)) stem.score = *score;
    if (!columns_[K::reconstructed]) return;
    const auto word = table_.cell(row, *columns_[K::reconstructed]);
    stem.reconstructed = !(word == "0" || word == "False" || word == "false" || word == "FALSE");
  }

  Stem stem_of(const GridRow& row) {
    Stem stem;
    stem.source_row = row.row;
    set_position(row, stem);
    if (bad_) return stem;
    for (std::size_t c = table_.header.size(); c < row.cells.size(); ++c) {
      if (row.cells[c].empty()) continue;
      bad_ = true;
      complain(row, table_.header.size(), "the row has " + std::to_string(row.cells.size()) + " fields, " + std::to_string(table_.header.size()) + " expected");
      return stem;
    }
    set_words(row, stem);
    stem.z_m = optional_number(row, columns_[K::z], columns_.z_m, "a height in metres");
    set_diameter(row, stem);
    if (const auto height = optional_number(row, columns_[K::height], columns_.height_m, "a height"); height && *height > 0.0) stem.height_m = height;
    set_axis(row, stem);
    set_quality(row, stem);
    return stem;
  }

  const StemTable& table_;
  const StemColumns& columns_;
  const ReadOptions& options_;
  DateReading dates_;
  bool numbers_from_one_ = false;
  bool bad_ = false;
};

void note_counts(const StemMaker& made, Inventory& inventory) {
  std::string text = "rows: " + std::to_string(made.rows_met_) + ", stems read: " + std::to_string(made.stems_.size());
  if (made.rows_bad_ > 0) text += ", bad rows left out: " + std::to_string(made.rows_bad_);
  const auto count = [&](StemStatus status) { return std::count_if(made.stems_.begin(), made.stems_.end(), [status](const Stem& s) { return s.status == status; }); };
  if (const auto dead = count(StemStatus::dead); dead > 0) text += ", dead by their status: " + std::to_string(dead);
  if (made.rows_absent_ > 0) text += ", stems not measured in this census left out: " + std::to_string(made.rows_absent_);
  if (const auto removed = count(StemStatus::removed); removed > 0) text += ", removed by their status: " + std::to_string(removed);
  if (made.rows_missing_ > 0) text += ", not found by their status, so not seen and left out: " + std::to_string(made.rows_missing_);
  inventory.source.notes.push_back(text);
  std::size_t measured = 0;
  for (const Stem& s : made.stems_) measured += s.dbh_m ? 1 : 0;
  if (measured < made.stems_.size()) inventory.source.notes.push_back("stems without a measured DBH: " + std::to_string(made.stems_.size() - measured));
}

/// The words of the status column that say nothing to us, with their rows.
Issues warn_of_unknown_codes(const StemTable& table, const StemColumns& columns, const std::map<std::string, std::size_t>& codes) {
  constexpr std::size_t codes_named = 8;
  if (codes.empty()) return {};
  std::vector<std::pair<std::string, std::size_t>> frequent(codes.begin(), codes.end());
  std::stable_sort(frequent.begin(), frequent.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string list;
  for (std::size_t i = 0; i < std::min(codes_named, frequent.size()); ++i)
    list += (i > 0 ? ", \"" : "\"") + frequent[i].first.substr(0, 40) + "\" (" + std::to_string(frequent[i].second) + (frequent[i].second == 1 ? " row)" : " rows)");
  if (frequent.size() > codes_named) list += ", ... (" + std::to_string(frequent.size()) + " words)";
  return {{Severity::warning, table.file, 0, table.header[*columns[K::status]], "unknown status: " + list + "; these stems are taken as living",
           "say what it means: --status \"" + frequent.front().first + "=dead\" (alive, dead, removed or missing)"}};
}

Issues issues_so_far(const StemTable& table, const StemColumns& columns, const StemMaker& made) {
  Issues issues = table.issues;
  for (const Issues& more : {columns.issues, made.issues_, made.not_a_number_issues()}) issues.insert(issues.end(), more.begin(), more.end());
  return issues;
}

Issue nothing_usable(const StemTable& table) {
  const char* text = table.rows.empty() ? "has a header and no rows" : "no row is usable";
  return {Severity::error, table.file, table.header_row, {}, text, "check the delimiter and the columns, or name them with --map"};
}

}  // namespace

Result<Inventory> inventory_from_table(OpenedTable opened, const ReadOptions& options) {
  const bool told = !opened.epsg && options.epsg;
  if (told && !is_known_epsg(*options.epsg)) {
    return Result<Inventory>::failure(Issue{Severity::error, opened.table.file, 0, {}, "there is no coordinate system EPSG:" + std::to_string(*options.epsg), "for example 25832"});
  }
  if (told) opened.table.notes.push_back("coordinate system: " + crs_name(*options.epsg) + " (EPSG:" + std::to_string(*options.epsg) + "), as told");
  auto result = inventory_from_table(std::move(opened.table), options, told ? options.epsg : opened.epsg);
  if (result) result->source.format = std::move(opened.format);
  return result;
}

Result<Inventory> inventory_from_table(StemTable table, const ReadOptions& options, std::optional<int> epsg) {
  if (const auto kept = keep_one_plot(table, options); !kept) return Result<Inventory>::failure(kept.issues);
  const auto columns = recognise_columns(table, options);
  if (!columns) return Result<Inventory>::failure(columns.issues);
  StemMaker made(table, *columns, options);
  made.run();

  Inventory inventory;
  inventory.name = inventory_name(table.file);
  inventory.source.path = table.file;
  inventory.source.notes = table.notes;
  inventory.source.notes.insert(inventory.source.notes.end(), columns->notes.begin(), columns->notes.end());
  Issues issues = issues_so_far(table, *columns, made);
  if (made.stems_.empty()) {
    issues.insert(issues.begin(), nothing_usable(table));
    return Result<Inventory>::failure(std::move(issues));
  }
  for (Issue& issue : leave_out_repeated_rows(table, *columns, made.stems_, made.rows_)) issues.push_back(std::move(issue));
  for (Issue& issue : warn_of_unknown_codes(table, *columns, made.unknown_codes_)) issues.push_back(std::move(issue));
  for (Issue& issue : warn_of_unread_dates(table, *columns, options)) issues.push_back(std::move(issue));
  note_counts(made, inventory);
  inventory.stems = std::move(made.stems_);
  inventory.source.epsg = epsg;
  for (Issue& issue : project_degrees(table, *columns, inventory)) issues.push_back(std::move(issue));
  std::vector<double> x_m, y_m;
  for (const Stem& s : inventory.stems) x_m.push_back(s.x_m), y_m.push_back(s.y_m);
  for (Issue& issue : warn_of_overlapping_plots(table, made.rows_, x_m, y_m, columns->position.scheme == PositionScheme::polar)) issues.push_back(std::move(issue));
  for (Issue& issue : warn_of_repeated_ids(table, *columns, inventory.stems)) issues.push_back(std::move(issue));
  set_dates(inventory, table, *columns, options);
  return {std::move(inventory), std::move(issues)};
}

}  // namespace stemwise
