#include "ui/frame.hpp"

#include <algorithm>

#include "ui/theme/tokens.hpp"

namespace stemwise::ui {

Color inventory_color(const ProjectState& state, InventoryId id) {
  const std::vector<InventoryId> order = state.by_date();
  return survey_color(static_cast<std::size_t>(std::find(order.begin(), order.end(), id) - order.begin()));
}

std::string stem_label(const ProjectState& state, StemRef stem) {
  const Inventory* inventory = state.find(stem.inventory);
  const Stem* found = state.find(stem);
  if (inventory == nullptr || found == nullptr) return "–";
  return inventory->name + ":" + found->source_id;
}

std::string survey_label(const ProjectState& state, InventoryId id) {
  const Inventory* inventory = state.find(id);
  if (inventory == nullptr) return "–";
  if (!inventory->date) return inventory->name;
  const int year = year_of(*inventory->date);
  const auto same_year = [&](const auto& other) { return other->id != id && other->date && year_of(*other->date) == year; };
  return std::any_of(state.inventories.begin(), state.inventories.end(), same_year) ? inventory->name : std::to_string(year);
}

StemRef unlink_target(const ProjectState& state, const ViewState& view) {
  const auto it = state.trees.find(view.selected_tree);
  if (it == state.trees.end() || it->second.stems.size() < 2) return {};
  const std::vector<StemRef>& stems = it->second.stems;
  if (std::find(stems.begin(), stems.end(), view.selected_stem) != stems.end()) return view.selected_stem;
  const std::vector<InventoryId> order = state.by_date();
  const auto place = [&](const StemRef& s) { return std::find(order.begin(), order.end(), s.inventory); };
  return *std::max_element(stems.begin(), stems.end(), [&](const StemRef& a, const StemRef& b) { return place(a) < place(b); });
}

const MatchRow* match_to_decide(const Derived& derived, TreeId tree) {
  if (const QueueRow* doubt = derived.doubt(tree); doubt != nullptr && doubt->match) return &derived.tables.matches[*doubt->match];
  const MatchRow* weakest = nullptr;
  for (const MatchRow* row : derived.matches_of(tree)) {
    if (row->state == MatchState::rejected) continue;
    if (weakest == nullptr || row->confidence < weakest->confidence) weakest = row;
  }
  return weakest;
}

}  // namespace stemwise::ui
