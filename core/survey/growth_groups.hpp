#pragma once
#include <string>

#include "core/survey/stand_growth.hpp"

namespace stemwise {

/// DBH change of the matched living stems of one species, or one DBH class, in one step. Metres.
struct GrowthGroup {
  InventoryId from, to;
  std::string species;               ///< of the earlier sighting, else of the later; "" in classes
  double low_cm = 0.0, high_cm = 0.0;  ///< class [low, high) of the earlier DBH; both 0 in species
  int n = 0;
  Estimate mean_m;                   ///< with its bootstrap interval, as in StandGrowth
  Estimate mean_m_per_year;          ///< each stem by its own years; both 0 where no stem has any
  bool has_years = false;
};

struct GrowthGroups {
  std::vector<GrowthGroup> by_species;  ///< per step, sorted by name; none where no stem has a species
  std::vector<GrowthGroup> by_class;    ///< per step, ascending; classes without a stem are left out
};

/// StandGrowth once more, species by species and class by class [k w, (k+1) w). Deterministic by seed.
GrowthGroups growth_groups(const ProjectState& state, const Tables& tables, double class_width_cm, const StandGrowthSettings& settings = {});

}  // namespace stemwise
