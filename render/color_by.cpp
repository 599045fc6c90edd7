#include "render/color_by.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "render/number_text.hpp"

namespace stemwise::render {
namespace {

constexpr int gradient_stops = 33;

struct Words {
  ColorBy by;
  const char* word;
  const char* label;
};
constexpr std::array<Words, 7> words{{{ColorBy::inventory, "inventory", "Inventory"},
                                      {ColorBy::fate, "fate", "Fate"},
                                      {ColorBy::dbh, "dbh", "DBH"},
                                      {ColorBy::growth, "growth", "DBH change"},
                                      {ColorBy::residual, "residual", "Residual"},
                                      {ColorBy::confidence, "confidence", "Confidence"},
                                      {ColorBy::times_seen, "times_seen", "Times seen"}}};

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

/// The fates a legend lists: those that occur, and survivor and missing always.
bool is_listed(Fate fate, int count) { return count > 0 || fate == Fate::survivor || fate == Fate::missing; }

std::vector<double> collect(const Tables& tables, ColorBy by) {
  std::vector<double> values;
  if (by == ColorBy::confidence) return values;
  values.reserve(tables.observations.size());
  for (const ObservationRow& row : tables.observations) {
    const std::optional<double>& value = by == ColorBy::dbh ? row.dbh_m : row.residual_m;
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  return values;
}

}  // namespace

const char* to_string(ColorBy by) { return words[static_cast<std::size_t>(by)].word; }
const char* label_of(ColorBy by) { return words[static_cast<std::size_t>(by)].label; }

std::optional<ColorBy> color_by_from(const std::string& word) {
  for (const Words& w : words)
    if (word == w.word) return w.by;
  return std::nullopt;
}

Colouring::Colouring(const ProjectState& state, const Tables& tables, ColorBy by, Theme theme) : by_(by), theme_(theme) {
  order_ = state.by_date();
  legend_.title = label_of(by);
  switch (by) {
    case ColorBy::inventory: describe_inventories(state, tables); break;
    case ColorBy::fate: describe_fates(tables); break;
    case ColorBy::times_seen: describe_times_seen(tables); break;
    case ColorBy::growth: describe_growth(tables); break;
    case ColorBy::dbh: describe_sequential(collect(tables, by), "cm", 100.0, std::nullopt); break;
    case ColorBy::residual: describe_sequential(collect(tables, by), "cm", 100.0, std::nullopt); break;
    case ColorBy::confidence: describe_sequential({}, "", 1.0, Range{0.0, 1.0}); break;
  }
}

Rgba Colouring::colour_of_inventory(InventoryId inventory) const {
  const auto at = std::find(order_.begin(), order_.end(), inventory);
  return survey_colour(static_cast<std::size_t>(at - order_.begin()));
}

void Colouring::describe_inventories(const ProjectState& state, const Tables&) {
  for (const InventoryId id : order_) {
    const Inventory* inventory = state.find(id);
    if (!inventory) continue;
    legend_.entries.push_back({inventory->name, colour_of_inventory(id), MarkShape::disc, static_cast<int>(inventory->stems.size())});
  }
}

void Colouring::describe_fates(const Tables& tables) {
  for (std::size_t i = 0; i < fate_count; ++i) {
    const Fate fate = static_cast<Fate>(i);
    if (is_listed(fate, tables.trees_by_fate[i]))
      legend_.entries.push_back({fate_label(fate), fate_colour(fate), fate_shape(fate), tables.trees_by_fate[i]});
  }
}

void Colouring::describe_times_seen(const Tables& tables) {
  const int most = std::max<int>(1, static_cast<int>(tables.inventories.size()));
  std::map<int, int> counts;
  for (const TreeRow& tree : tables.trees) ++counts[tree.times_seen];
  range_ = {1.0, std::max(2.0, static_cast<double>(most))};
  for (int n = 1; n <= most; ++n) {
    const std::string label = n == 1 ? "Once" : n == 2 ? "Twice" : std::to_string(n) + " times";
    legend_.entries.push_back({label, sequential(static_cast<double>(n)), MarkShape::disc, counts[n]});
  }
}

void Colouring::describe_sequential(std::vector<double> values, std::string unit, double scale, std::optional<Range> fixed) {
  legend_.unit = std::move(unit);
  if (fixed) {
    range_ = *fixed;
  } else {
    const double step = nice_step(percentile(values, 0.98) * scale / 4.0);
    range_.low = std::floor(percentile(values, 0.02) * scale / step) * step / scale;
    range_.high = std::max(range_.low + step / scale, std::ceil(percentile(values, 0.98) * scale / step) * step / scale);
  }
  for (int i = 0; i < gradient_stops; ++i) legend_.gradient.push_back(cividis(static_cast<double>(i) / (gradient_stops - 1)));
  const double step = nice_step((range_.high - range_.low) * scale / 4.0);
  for (double tick = range_.low * scale; tick <= range_.high * scale + 1e-9; tick += step)
    legend_.ticks.push_back({(tick / scale - range_.low) / (range_.high - range_.low), number_text(tick, decimals_of(step))});
}

std::optional<double> Colouring::change_of(const TreeRow& tree) const {
  if (!is_total_change_) return tree.growth_m_per_year;
  std::optional<double> first, last;
  for (const std::optional<double>& dbh : tree.dbh_per_inventory_m) {
    if (!dbh) continue;
    if (first) last = dbh;
    if (!first) first = dbh;
  }
  return first && last ? std::optional(*last - *first) : std::nullopt;
}

void Colouring::describe_growth(const Tables& tables) {
  is_total_change_ = std::none_of(tables.trees.begin(), tables.trees.end(), [](const TreeRow& tree) { return tree.growth_m_per_year.has_value(); });
  std::vector<double> rates;
  for (const TreeRow& tree : tables.trees)
    if (const auto change = change_of(tree)) rates.push_back(std::abs(*change));
  std::vector<double> errors;
  for (const GrowthRow& row : tables.growth) {
    if (is_total_change_) errors.push_back(std::sqrt(2.0) * row.dbh_error_m);
    if (!is_total_change_ && row.years && *row.years > 0.0) errors.push_back(std::sqrt(2.0) * row.dbh_error_m / *row.years);
  }
  growth_error_m_per_year_ = percentile(errors, 0.5);
  const double units_per_m = is_total_change_ ? 100.0 : 1000.0;  // a whole change is told in cm
  const double step = nice_step(std::max(percentile(rates, 0.98), 1e-4) * units_per_m / 2.0);
  range_.high = std::ceil(std::max(percentile(rates, 0.98), 1e-4) * units_per_m / step) * step / units_per_m;
  range_.low = -range_.high;
  legend_.unit = is_total_change_ ? "cm in all (no dates)" : "mm per year";
  for (int i = 0; i < gradient_stops; ++i)
    legend_.gradient.push_back(purple_white_orange(2.0 * i / (gradient_stops - 1) - 1.0, theme_));
  for (double tick = -range_.high * units_per_m; tick <= range_.high * units_per_m + 1e-9; tick += step)
    legend_.ticks.push_back({0.5 + 0.5 * tick / (range_.high * units_per_m), signed_text(tick, decimals_of(step))});
  legend_.entries.push_back({"Within error", neutral_grey(theme_), MarkShape::disc, std::nullopt});
  legend_.entries.push_back({"Unknown", neutral_grey(theme_), MarkShape::hollow, std::nullopt});
}

Rgba Colouring::sequential(const std::optional<double>& value) const {
  if (!value || !std::isfinite(*value)) return neutral_grey(theme_);
  return cividis((*value - range_.low) / (range_.high - range_.low));
}

MarkStyle Colouring::style_of(const ObservationRow& row, const TreeRow* tree, bool whole) const {
  const auto measured = [this](const std::optional<double>& value) {
    return MarkStyle{sequential(value), value ? MarkShape::disc : MarkShape::hollow};
  };
  switch (by_) {
    case ColorBy::inventory: return {colour_of_inventory(row.stem.inventory), MarkShape::disc};
    case ColorBy::fate: {
      const Fate fate = whole && tree ? tree->fate : row.fate;
      return {fate_colour(fate), fate_shape(fate)};
    }
    case ColorBy::dbh: return measured(row.dbh_m);
    case ColorBy::residual: return measured(row.residual_m);
    case ColorBy::confidence: return measured(tree && tree->times_seen > 1 ? std::optional(tree->confidence) : row.confidence);
    case ColorBy::times_seen: return measured(tree ? std::optional<double>(tree->times_seen) : std::nullopt);
    case ColorBy::growth: break;
  }
  const std::optional<double> change = tree ? change_of(*tree) : std::nullopt;
  if (!change) return {neutral_grey(theme_), MarkShape::hollow};
  const double rate = *change;
  if (std::abs(rate) <= growth_error_m_per_year_) return {neutral_grey(theme_), MarkShape::disc};
  return {purple_white_orange(rate / range_.high, theme_), MarkShape::disc};
}

MarkStyle Colouring::style_of_unplaced(InventoryId inventory, const Stem& stem) const {
  if (by_ == ColorBy::dbh) return {sequential(stem.dbh_m), stem.dbh_m ? MarkShape::disc : MarkShape::hollow};
  return {colour_of_inventory(inventory), MarkShape::disc};
}

}  // namespace stemwise::render
