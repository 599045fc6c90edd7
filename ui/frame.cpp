#include "ui/frame.hpp"

#include <algorithm>
#include <set>

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
  std::set<int> years;
  for (const auto& other : state.inventories) {
    if (!other->date || !years.insert(year_of(*other->date)).second) return inventory->name;
  }
  return std::to_string(year_of(*inventory->date));
}

InventoryId survey_to_compare(const ProjectState& state, const ViewState& view) {
  if (view.selected_inventory != state.reference && state.alignments.contains(view.selected_inventory)) return view.selected_inventory;
  InventoryId last;
  for (const InventoryId id : state.by_date()) {
    if (id != state.reference && state.alignments.contains(id)) last = id;
  }
  return last;
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

const MatchRow* match_to_decide(const Derived& derived, const ViewState& view) {
  std::vector<const MatchRow*> rows = derived.matches_of(view.selected_tree);
  std::erase_if(rows, [](const MatchRow* row) { return row->state == MatchState::rejected; });
  for (const auto end : {&MatchRow::b, &MatchRow::a}) {
    for (const MatchRow* row : rows) {
      if (view.selected_stem.index >= 0 && row->*end == view.selected_stem) return row;
    }
  }
  const QueueRow* doubt = derived.doubt(view.selected_tree);
  if (doubt != nullptr && !doubt->decided) return doubt->match ? &derived.tables.matches[*doubt->match] : nullptr;
  const auto weakest = std::min_element(rows.begin(), rows.end(), [](const MatchRow* a, const MatchRow* b) { return a->confidence < b->confidence; });
  return weakest == rows.end() ? nullptr : *weakest;
}

}  // namespace stemwise::ui
