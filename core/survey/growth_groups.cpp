#include "core/survey/growth_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace stemwise {
namespace {

struct Changes {
  std::vector<double> change_m, per_year_m;
};

/// Changes by group, and the groups of one step.
struct StepChanges {
  std::map<std::string, Changes> by_species;
  std::map<int, Changes> by_class;
};

void add(Changes& changes, const MatchRow& match) {
  changes.change_m.push_back(*match.change_m);
  if (match.years && *match.years > 0.0) changes.per_year_m.push_back(*match.change_m / *match.years);
}

std::vector<StepChanges> changes_per_step(const ProjectState& state, const Tables& tables, double width_cm) {
  std::unordered_map<InventoryId, std::size_t> place;
  for (std::size_t i = 0; i < tables.inventories.size(); ++i) place[tables.inventories[i]] = i;
  std::vector<StepChanges> steps(tables.inventories.empty() ? 0 : tables.inventories.size() - 1);
  for (const MatchRow& match : tables.matches) {
    if (match.state == MatchState::rejected || !match.change_m || place.at(match.a.inventory) + 1 != place.at(match.b.inventory)) continue;
    const Stem &earlier = *state.find(match.a), &later = *state.find(match.b);
    if (!is_living(earlier.status) || !is_living(later.status)) continue;
    StepChanges& step = steps[place.at(match.a.inventory)];
    add(step.by_species[earlier.species.empty() ? later.species : earlier.species], match);
    add(step.by_class[static_cast<int>(std::floor((*match.dbh_a_m * 100.0 + 1e-6) / width_cm))], match);
  }
  return steps;
}

GrowthGroup group_of(const Changes& changes, const StandGrowthSettings& settings) {
  GrowthGroup group;
  group.n = static_cast<int>(changes.change_m.size());
  group.mean_m = bootstrap_mean(changes.change_m, settings);
  group.mean_m_per_year = bootstrap_mean(changes.per_year_m, settings);
  group.has_years = !changes.per_year_m.empty();
  return group;
}

}  // namespace

GrowthGroups growth_groups(const ProjectState& state, const Tables& tables, double class_width_cm, const StandGrowthSettings& settings) {
  GrowthGroups groups;
  const std::vector<StepChanges> steps = changes_per_step(state, tables, class_width_cm);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool any_species = std::any_of(steps[i].by_species.begin(), steps[i].by_species.end(), [](const auto& entry) { return !entry.first.empty(); });
    for (const auto& [species, changes] : steps[i].by_species) {
      if (!any_species) break;
      GrowthGroup group = group_of(changes, settings);
      group.from = tables.inventories[i], group.to = tables.inventories[i + 1];
      group.species = species;
      groups.by_species.push_back(std::move(group));
    }
    for (const auto& [k, changes] : steps[i].by_class) {
      GrowthGroup group = group_of(changes, settings);
      group.from = tables.inventories[i], group.to = tables.inventories[i + 1];
      group.low_cm = k * class_width_cm, group.high_cm = (k + 1) * class_width_cm;
      groups.by_class.push_back(std::move(group));
    }
  }
  return groups;
}

}  // namespace stemwise
