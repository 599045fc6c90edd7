#include "io/stem_units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/plot_filter.hpp"

namespace stemwise {
namespace {

using K = ColumnKind;

enum class Layout { none, forest_geo, fia, realtime_trees };

bool has(const StemTable& table, const std::string& base) {
  return std::any_of(table.names.begin(), table.names.end(), [&](const ColumnName& n) { return n.base == base; });
}

/// Layouts whose units are known by convention.
Layout layout_of(const StemTable& table) {
  const bool grid = (has(table, "gx") && has(table, "gy")) || (has(table, "px") && has(table, "py")) || (has(table, "lx") && has(table, "ly"));
  if (grid && (has(table, "stemtag") || has(table, "stemid") || has(table, "quadrat"))) return Layout::forest_geo;
  if (has(table, "subp") && has(table, "dist") && has(table, "azimuth") && has(table, "dia")) return Layout::fia;
  if (has(table, "locationx") && has(table, "dbhapproximation")) return Layout::realtime_trees;
  return Layout::none;
}

/// The value that a share of the sorted values does not exceed.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::string short_number(double value) {
  std::string text = std::to_string(std::round(value * 100.0) / 100.0);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

struct Unit {
  std::string word;
  std::string how;       ///< "by header"
  bool guessed = false;
};

class UnitDecision {
 public:
  UnitDecision(const StemTable& table, const ReadOptions& options, StemColumns& columns)
      : table_(table), options_(options), columns_(columns), layout_(layout_of(table)) {}

  void decide() {
    decide_position();
    for (const K kind : {K::dbh, K::circumference}) {
      if (const auto at = columns_[kind]) {
        const Unit unit = diameter_unit(kind, *at);
        columns_.dbh_m = metres_per(unit.word) / (kind == K::circumference ? std::numbers::pi : 1.0);
        note(kind, *at, unit, kind == K::circumference ? ", divided by pi" : "");
        warn_of_mixed_units(*at);
      }
    }
    if (const auto at = columns_[K::dbh_approximation]) columns_.dbh_approximation_m = metres_per(named(K::dbh_approximation, *at, "m").word);
    if (const auto at = columns_[K::z]) {
      const Unit unit = named(K::z, *at, "m");
      columns_.z_m = metres_per(unit.word);
      note(K::z, *at, unit);
    }
    if (const auto at = columns_[K::height]) {
      const Unit unit = named(K::height, *at, layout_ == Layout::fia ? "ft" : "m");
      columns_.height_m = metres_per(unit.word);
      note(K::height, *at, unit);
    }
  }

 private:
  void note(K kind, std::size_t column, const Unit& unit, const std::string& more = {}) {
    columns_.notes.push_back(std::string(to_string(kind)) + ": column " + table_.header[column] + ", " + unit.word + more + " (" + unit.how + ")");
    columns_.units.push_back({kind, unit.word, unit.how, unit.guessed});
    if (!unit.guessed) return;
    columns_.issues.push_back({Severity::warning, table_.file, table_.header_row, table_.header[column],
                               "unit guessed: " + unit.word + " (" + unit.how + ")",
                               std::string("if that is wrong: --unit ") + to_string(kind) + "=UNIT"});
  }

  /// Whole numbers that are ten times as large as those with a decimal: millimetres among centimetres.
  void warn_of_mixed_units(std::size_t column) const {
    constexpr double far_apart = 5.0, least_share = 0.1;
    std::vector<double> whole, broken;
    for (const double value : table_.numbers(column))
      if (value > 0.0) (value == std::floor(value) ? whole : broken).push_back(value);
    const double least = least_share * static_cast<double>(whole.size() + broken.size());
    if (whole.size() < 3 || broken.size() < 3 || static_cast<double>(std::min(whole.size(), broken.size())) < least) return;
    const double large = *median_of(whole), small = *median_of(broken);
    if (large < far_apart * small) return;
    columns_.issues.push_back({Severity::warning, table_.file, table_.header_row, table_.header[column],
                               "two units seem to be mixed: whole numbers around " + short_number(large) + " and decimals around " + short_number(small) + "; all were read as one",
                               "bring the column to one unit"});
  }

  std::optional<Unit> told(K kind, std::size_t column) const {
    if (const auto it = options_.units.find(to_string(kind)); it != options_.units.end()) return Unit{unit_from_word(it->second), "as told"};
    if (!table_.names[column].unit.empty()) return Unit{table_.names[column].unit, "by header"};
    return std::nullopt;
  }

  Unit named(K kind, std::size_t column, const char* usual) const {
    if (auto unit = told(kind, column); unit && metres_per(unit->word) > 0.0) return *unit;
    return {usual, "usual"};
  }

  Unit diameter_unit(K kind, std::size_t column) const {
    if (auto unit = told(kind, column); unit && metres_per(unit->word) > 0.0) return *unit;
    if (layout_ == Layout::forest_geo) return {"mm", "ForestGEO layout", columns_.census_year.has_value()};
    if (layout_ == Layout::realtime_trees) return {"m", "RealtimeTrees layout"};
    if (layout_ == Layout::fia) return {"in", "FIA layout", true};
    std::vector<double> values = table_.numbers(column);
    std::erase_if(values, [](double v) { return v <= 0.0; });
    if (values.empty()) return {"cm", "no values"};
    const double around = kind == K::circumference ? std::numbers::pi : 1.0;
    const double middle = *median_of(values);
    const double high = quantile(values, 0.98);
    const std::string how = "median " + short_number(middle);
    if (middle <= 2.0 * around && high <= 5.0 * around) return {"m", how, true};
    if (high > 250.0 * around || middle > 150.0 * around) return {"mm", how, true};
    return {"cm", how, true};
  }

  void decide_position() {
    const auto& p = columns_.position;
    switch (p.scheme) {
      case PositionScheme::geographic:
        columns_.notes.push_back("position: columns " + table_.header[p.first] + " and " + table_.header[p.second] + ", degrees, projected to UTM");
        return;
      case PositionScheme::polar: return decide_polar();
      case PositionScheme::quadrat:
        columns_.notes.push_back("position: columns " + table_.header[p.first] + " and " + table_.header[p.second] + " in 20 m quadrats " +
                                 table_.header[p.quadrat]);
        columns_.issues.push_back({Severity::warning, table_.file, table_.header_row, table_.header[p.quadrat],
                                   "positions were put together from 20 m quadrats named by column and row", "check the extent"});
        return;
      case PositionScheme::cartesian: break;
    }
    Unit unit{"m", "usual"};
    if (auto word = told(K::x, p.first); word && metres_per(word->word) > 0.0) unit = *word;
    else if (looks_like_decimetres()) unit = {"dm", "whole numbers and an unlikely low density in metres", true};
    columns_.position_m = metres_per(unit.word);
    note(K::x, p.first, unit);
    columns_.notes.push_back("y: column " + table_.header[p.second]);
  }

  void decide_polar() {
    const auto& p = columns_.position;
    Unit unit{layout_ == Layout::fia ? "ft" : "m", layout_ == Layout::fia ? "FIA layout" : "usual", layout_ == Layout::fia};
    if (auto word = told(K::distance, p.second); word && metres_per(word->word) > 0.0) unit = *word;
    columns_.position_m = metres_per(unit.word);
    note(K::distance, p.second, unit);
    Unit angle{"deg", "usual"};
    const std::vector<double> values = table_.numbers(p.first);
    const double largest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
    const bool whole = std::all_of(values.begin(), values.end(), [](double v) { return v == std::floor(v); });
    if (auto word = told(K::azimuth, p.first); word && radians_per(word->word) > 0.0) angle = *word;
    else if (largest <= 400.0 && quantile(values, 0.98) > 360.0) angle = {"gon", "largest " + short_number(largest), true};
    else if (largest <= 6.3 && !whole && values.size() > 5) angle = {"rad", "largest " + short_number(largest), true};
    columns_.azimuth_rad = radians_per(angle.word);
    note(K::azimuth, p.first, angle);
  }

  /// Whole numbers, and fewer than 30 stems per hectare if they were metres but a forest if decimetres.
  bool looks_like_decimetres() const {
    const auto& p = columns_.position;
    const PlotGroups groups = plot_groups(table_);
    std::vector<std::array<double, 4>> boxes(std::max<std::size_t>(groups.values.size(), 1), {1e300, 1e300, -1e300, -1e300});
    std::vector<double> count(boxes.size(), 0.0);
    for (std::size_t r = 0; r < table_.rows.size(); ++r) {
      const Quantity x = parse_quantity(table_.cell(table_.rows[r], p.first), table_.style);
      const Quantity y = parse_quantity(table_.cell(table_.rows[r], p.second), table_.style);
      if (x.kind != Quantity::Kind::number || y.kind != Quantity::Kind::number) continue;
      if (x.value != std::floor(x.value) || y.value != std::floor(y.value)) return false;
      auto& b = boxes[groups.group_of_row[r]];
      b = {std::min(b[0], x.value), std::min(b[1], y.value), std::max(b[2], x.value), std::max(b[3], y.value)};
      ++count[groups.group_of_row[r]];
    }
    std::vector<double> per_ha;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double area_sq = (boxes[i][2] - boxes[i][0]) * (boxes[i][3] - boxes[i][1]);
      if (count[i] >= 10 && area_sq > 0.0) per_ha.push_back(count[i] / area_sq * 1e4);
    }
    const auto density = median_of(per_ha);
    return density && *density < 30.0 && *density > 0.2;
  }

  const StemTable& table_;
  const ReadOptions& options_;
  StemColumns& columns_;
  Layout layout_;
};

}  // namespace

void decide_units(const StemTable& table, const ReadOptions& options, StemColumns& columns) { UnitDecision(table, options, columns).decide(); }

}  // namespace stemwise
