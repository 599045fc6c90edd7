#pragma once
#include <vector>

#include "core/project/commands.hpp"
#include "core/project/project.hpp"

namespace stemwise::test {

/// A forest of `trees` stems on a 5 m grid, 30 cm + i, `growth_m` later; ids "1", "2", ...
inline Inventory grid_inventory(const std::string& name, Date date, int trees, double growth_m, double shift_m = 0.0) {
  Inventory inventory;
  inventory.name = name;
  inventory.date = date;
  for (int i = 0; i < trees; ++i) {
    Stem stem;
    stem.source_id = std::to_string(i + 1);
    stem.x_m = 5.0 * (i % 10) + shift_m;
    stem.y_m = 5.0 * (i / 10);
    stem.dbh_m = 0.30 + 0.01 * i + growth_m;
    inventory.stems.push_back(stem);
  }
  return inventory;
}

/// Stem i of every survey is the same tree.
inline SurveyAlignment straight_alignment(const ProjectState& state) {
  SurveyAlignment result;
  result.reference = state.reference;
  for (const auto& inventory : state.inventories) {
    InventoryAlignment alignment;
    alignment.inventory = inventory->id;
    alignment.status = inventory->id == state.reference ? AlignmentStatus::reference : AlignmentStatus::aligned;
    alignment.position_noise_m = 0.1;
    result.inventories.push_back(alignment);
  }
  for (std::size_t i = 1; i < state.inventories.size(); ++i) {
    const auto &a = state.inventories[i - 1], &b = state.inventories[i];
    for (std::size_t k = 0; k < std::min(a->stems.size(), b->stems.size()); ++k) {
      Match match{{a->id, static_cast<std::int64_t>(k)}, {b->id, static_cast<std::int64_t>(k)}};
      match.confidence = 0.9;
      result.matches.push_back(match);
    }
  }
  return result;
}

/// Three surveys (2013, 2018, 2023) of 20 trees, aligned, everything matched.
inline Project aligned_project() {
  Project project;
  project.execute(add_inventory(grid_inventory("2013", date_from_civil(2013, 7, 1), 20, 0.0)));
  project.execute(add_inventory(grid_inventory("2018", date_from_civil(2018, 7, 1), 20, 0.01)));
  project.execute(add_inventory(grid_inventory("2023", date_from_civil(2023, 7, 1), 20, 0.025)));
  project.execute(apply_alignment(straight_alignment(project.state()), {}));
  return project;
}

inline StemRef stem_of(const Project& project, std::size_t inventory, std::int64_t index) {
  return {project.state().inventories.at(inventory)->id, index};
}

}  // namespace stemwise::test
