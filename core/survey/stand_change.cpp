#include "core/survey/stand_change.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <numbers>
#include <unordered_map>

#include "core/survey/drawn_ground.hpp"
#include "core/base/quantile.hpp"
#include "core/geometry/shared_area.hpp"

namespace stemwise {
namespace {

constexpr std::array<const char*, component_count> words{"survivor", "ingrowth", "missed_earlier", "new_unresolved",  "not_surveyed_before", "dead",
                                                         "removed",  "missing",  "missed_later",   "gone_unresolved", "not_surveyed_after"};
constexpr std::array<const char*, component_count> labels{
    "Survivors", "Ingrowth", "Missed earlier", "New, at the edge", "Not surveyed before", "Dead", "Removed", "Missing inside coverage",
    "Missed later", "Gone, at the edge", "Not surveyed after"};

double basal_area_sq_m(double dbh_m) { return std::numbers::pi / 4.0 * dbh_m * dbh_m; }

/// A living stem of one survey.
struct Standing {
  const ObservationRow* row = nullptr;
  const Stem* stem = nullptr;
  bool alive() const { return stem != nullptr && is_living(stem->status); }
};

/// One tree at both ends of a step.
struct Ends {
  Standing earlier, later;
};

Component component_of_loss(Fate fate) {
  switch (fate) {
    case Fate::survivor: return Component::missed_later;
    case Fate::dead: return Component::dead;
    case Fate::removed: return Component::removed;
    case Fate::missing: return Component::missing;
    case Fate::outside_coverage: return Component::not_surveyed_after;
    case Fate::ingrowth:
    case Fate::missed_earlier:
    case Fate::unresolved: break;
  }
  return Component::gone_unresolved;
}

Component component_of_new(Fate arrival) {
  switch (arrival) {
    case Fate::ingrowth: return Component::ingrowth;
    case Fate::survivor:
    case Fate::missed_earlier: return Component::missed_earlier;
    case Fate::outside_coverage: return Component::not_surveyed_before;
    case Fate::missing:
    case Fate::dead:
    case Fate::removed:
    case Fate::unresolved: break;
  }
  return Component::new_unresolved;
}

std::optional<double> diameter(const Standing& end) {
  if (end.row == nullptr || !end.row->dbh_m || !std::isfinite(*end.row->dbh_m) || *end.row->dbh_m <= 0.0) return std::nullopt;
  return end.row->dbh_m;
}

/// Adds trees to one step.
class Step {
 public:
  /// The dates of the surveys stand in for those of stems that have none.
  Step(StandChange& change, double class_width_cm, std::optional<Date> from, std::optional<Date> to)
      : change_(change), width_cm_(class_width_cm), from_date_(from), to_date_(to) {}

  void add(const Ends& ends) {
    const bool before = ends.earlier.alive(), after = ends.later.alive();
    if (!before && !after) return;
    if ((before && !diameter(ends.earlier)) || (after && !diameter(ends.later))) {
      ++change_.without_dbh;
      return;
    }
    const std::optional<double> earlier_m = before ? diameter(ends.earlier) : std::nullopt, later_m = after ? diameter(ends.later) : std::nullopt;
    const Component component = component_of(ends, before, after);
    const std::string& species = before ? ends.earlier.stem->species : ends.later.stem->species;
    for (ComponentTable* table : {&change_.all, &species_[species], &classes_[class_of(before ? *earlier_m : *later_m)]}) {
      ComponentSum& sum = (*table)[static_cast<std::size_t>(component)];
      ++sum.stems;
      if (before) sum.earlier_sq_m += basal_area_sq_m(*earlier_m);
      if (after) sum.later_sq_m += basal_area_sq_m(*later_m);
    }
    if (component == Component::survivor) add_growth(ends, basal_area_sq_m(*later_m) - basal_area_sq_m(*earlier_m));
  }

  void finish() {
    for (auto& [name, table] : species_) change_.by_species.push_back({name, table});
    for (auto& [k, table] : classes_) change_.by_class.push_back({static_cast<double>(k) * width_cm_, static_cast<double>(k + 1) * width_cm_, table});
    if (dated_ && !spans_.empty()) change_.survivor_growth_sq_m_per_year = growth_per_year_sq_m_;
    if (!spans_.empty()) change_.years = median(spans_);
  }

 private:
  static Component component_of(const Ends& ends, bool before, bool after) {
    if (before && after) return Component::survivor;
    if (before) return component_of_loss(ends.earlier.row->fate);
    return component_of_new(ends.later.row->arrival.value_or(Fate::unresolved));
  }
  // A hundredth of a millimetre of slack: 0.30 m is 30 cm also where binary fractions say 29.999999999999996.
  int class_of(double dbh_m) const { return static_cast<int>(std::floor((dbh_m * 100.0 + 1e-6) / width_cm_)); }

  void add_growth(const Ends& ends, double growth_sq_m) {
    const auto from = ends.earlier.stem->date ? ends.earlier.stem->date : from_date_, to = ends.later.stem->date ? ends.later.stem->date : to_date_;
    if (!from || !to || *to <= *from) {
      dated_ = false;
      return;
    }
    spans_.push_back(years_between(*from, *to));
    growth_per_year_sq_m_ += growth_sq_m / spans_.back();
  }

  StandChange& change_;
  double width_cm_;
  std::optional<Date> from_date_, to_date_;
  bool dated_ = true;
  double growth_per_year_sq_m_ = 0.0;
  std::vector<double> spans_;
  std::map<std::string, ComponentTable> species_;
  std::map<int, ComponentTable> classes_;
};

void set_area(const Tables& tables, const ChangeOptions& options, StandChange& change) {
  if (options.area_ha) {
    change.area_ha = options.area_ha;
    change.area_source = "given";
    return;
  }
  const Polygon *from = nullptr, *to = nullptr;
  for (const CoverageRow& row : tables.coverages) {
    if (row.inventory == change.from) from = &row.in_reference;
    if (row.inventory == change.to) to = &row.in_reference;
  }
  if (from == nullptr || to == nullptr || from->empty() || to->empty()) return;
  const double shared_sq_m = shared_area_sq_m(*from, *to);
  if (shared_sq_m <= 0.0) return;
  change.area_ha = shared_sq_m / 10000.0;
  change.area_source = "ground covered by both surveys";
}

using Rows = std::unordered_map<InventoryId, std::vector<const ObservationRow*>>;

Rows rows_by_survey(const Tables& tables) {
  Rows rows;
  for (const ObservationRow& row : tables.observations) rows[row.stem.inventory].push_back(&row);
  return rows;
}

StandChange change_of(const ProjectState& state, const Tables& tables, const Rows& rows, std::size_t from, const ChangeOptions& options) {
  StandChange change;
  change.from = tables.inventories[from];
  change.to = tables.inventories[from + 1];
  const auto from_date = state.find(change.from)->date, to_date = state.find(change.to)->date;
  if (from_date && to_date && *to_date > *from_date) change.years = years_between(*from_date, *to_date);
  Step step(change, options.class_width_cm, from_date, to_date);
  std::map<TreeId, Ends> trees;
  std::set<TreeId> beyond;  // the ground that a person drew for the survey that saw it
  const auto take = [&](InventoryId id, Standing Ends::*end) {
    const auto found = rows.find(id);
    if (found == rows.end()) return;
    for (const ObservationRow* row : found->second) {
      trees[row->tree].*end = {row, state.find(row->stem)};
      if (!options.area_ha && !is_on_drawn_ground(tables, id, row->position_m)) beyond.insert(row->tree);
    }
  };
  take(change.from, &Ends::earlier);
  take(change.to, &Ends::later);
  for (const auto& [id, ends] : trees)
    if (!beyond.contains(id)) step.add(ends);
  change.beyond_drawn = static_cast<int>(beyond.size());
  step.finish();
  set_area(tables, options, change);
  return change;
}

}  // namespace

const char* to_string(Component component) { return words[static_cast<std::size_t>(component)]; }
const char* component_label(Component component) { return labels[static_cast<std::size_t>(component)]; }
bool is_loss(Component component) { return component >= Component::dead; }
const ComponentSum& of(const ComponentTable& table, Component component) { return table[static_cast<std::size_t>(component)]; }

ComponentSum earlier_stock(const ComponentTable& table) {
  ComponentSum stock;
  for (std::size_t i = 0; i < component_count; ++i) {
    const auto component = static_cast<Component>(i);
    if (component != Component::survivor && !is_loss(component)) continue;
    stock.stems += table[i].stems;
    stock.earlier_sq_m += table[i].earlier_sq_m;
  }
  return stock;
}

ComponentSum later_stock(const ComponentTable& table) {
  ComponentSum stock;
  for (std::size_t i = 0; i < component_count; ++i) {
    if (is_loss(static_cast<Component>(i))) continue;
    stock.stems += table[i].stems;
    stock.later_sq_m += table[i].later_sq_m;
  }
  return stock;
}

std::optional<PeriodicIncrement> periodic_increment(const StandChange& change) {
  if (!change.years || *change.years <= 0.0) return std::nullopt;
  const double hectares = change.area_ha.value_or(1.0), per = 1.0 / (*change.years * hectares);
  const auto earlier = [&](Component c) { return of(change.all, c).earlier_sq_m; };
  PeriodicIncrement increment;
  increment.per_ha = change.area_ha.has_value();
  increment.survivor_growth_sq_m =
      change.survivor_growth_sq_m_per_year ? *change.survivor_growth_sq_m_per_year / hectares : of(change.all, Component::survivor).growth_sq_m() * per;
  increment.ingrowth_sq_m = of(change.all, Component::ingrowth).later_sq_m * per;
  increment.mortality_sq_m = (earlier(Component::dead) + earlier(Component::missing)) * per;
  increment.removal_sq_m = earlier(Component::removed) * per;
  return increment;
}

std::vector<StandChange> stand_changes(const ProjectState& state, const Tables& tables, const ChangeOptions& options) {
  std::vector<StandChange> changes;
  const Rows rows = rows_by_survey(tables);
  for (std::size_t i = 0; i + 1 < tables.inventories.size(); ++i) changes.push_back(change_of(state, tables, rows, i, options));
  return changes;
}

}  // namespace stemwise
