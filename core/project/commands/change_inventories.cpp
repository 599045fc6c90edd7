#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/project/assign_trees.hpp"
#include "core/project/change_reference.hpp"
#include "core/project/commands.hpp"
#include "core/project/commands/whole_state.hpp"
#include "core/project/rough_pose_key.hpp"

namespace stemwise {
namespace {

std::string free_name(const ProjectState& state, const std::string& wanted) {
  if (state.find(wanted) == nullptr) return wanted;
  for (int n = 2;; ++n) {
    const std::string name = wanted + "-" + std::to_string(n);
    if (state.find(name) == nullptr) return name;
  }
}

void forget_alignment(ProjectState& state) {
  state.alignments.clear();
  state.pairs.clear();
  std::erase_if(state.matches, [](const auto& entry) { return entry.second.state == MatchState::automatic; });
}

/// No match is between its stems any more, nor is one of them a second choice.
void forget_matches_of(ProjectState& state, InventoryId id) {
  std::erase_if(state.matches, [&](const auto& m) { return m.first.first.inventory == id || m.first.second.inventory == id; });
  for (auto& entry : state.matches) {
    Match& match = entry.second;
    if (!match.second_choice || match.second_choice->inventory != id) continue;
    match.second_choice.reset();
    match.second_distance_m.reset();
  }
}

/// The sightings before and after the one that goes stay one tree: a match between them takes the place of the two.
void bridge_over(ProjectState& state, InventoryId gone) {
  const std::vector<InventoryId> order = state.by_date();
  const auto place = [&](const StemRef& stem) { return std::find(order.begin(), order.end(), stem.inventory); };
  for (const auto& entry : state.trees) {
    std::vector<StemRef> stems = entry.second.stems;
    std::sort(stems.begin(), stems.end(), [&](const StemRef& a, const StemRef& b) { return place(a) < place(b); });
    for (std::size_t i = 1; i + 1 < stems.size(); ++i) {
      if (stems[i].inventory != gone) continue;
      const StemPair across = ordered(stems[i - 1], stems[i + 1]);
      const auto before = state.matches.find(ordered(stems[i - 1], stems[i])), after = state.matches.find(ordered(stems[i], stems[i + 1]));
      if (state.matches.contains(across) || before == state.matches.end() || after == state.matches.end()) continue;
      const Match &first = before->second, &second = after->second;
      const bool by_hand = first.state != MatchState::automatic && second.state != MatchState::automatic;
      const double distance_m = (state.stem_in_reference_m(across.first) - state.stem_in_reference_m(across.second)).head<2>().norm();
      state.matches[across] = {across.first, across.second, distance_m, std::min(first.confidence, second.confidence), by_hand ? MatchState::linked : MatchState::automatic, {}, {}};
    }
  }
}

/// Positions that a person gave for it, or in its frame: its number may become another survey's.
void forget_positions_of(ProjectState& state, InventoryId id) {
  const std::string in_its_frame = std::to_string(id.value) + " ";
  std::erase_if(state.settings, [&](const auto& setting) { return is_rough_pose_key(setting.first) && (setting.first == rough_pose_key(id) || setting.second.starts_with(in_its_frame)); });
}

/// A tree that has no other stem is gone; where none is left, ids begin again.
void forget_stems_of(ProjectState& state, InventoryId id) {
  forget_matches_of(state, id);
  for (auto& [tree_id, tree] : state.trees) std::erase_if(tree.stems, [&](const StemRef& stem) { return stem.inventory == id; });
  std::erase_if(state.trees, [](const auto& entry) { return entry.second.stems.empty(); });
  state.tree_of_stem.erase(id);
  if (state.trees.empty()) state.next_tree = 1;
  const auto coverage = state.coverages.find(id);
  if (coverage != state.coverages.end() && coverage->second.source != CoverageSource::drawn) state.coverages.erase(coverage);
}

bool is_spoken_of(const ProjectState& state) {
  return std::any_of(state.trees.begin(), state.trees.end(), [](const auto& entry) { return entry.second.fate_by_hand || !entry.second.note.empty(); });
}

void begin_ids_again(ProjectState& state) {
  state.trees.clear();
  state.tree_of_stem.clear();
  state.next_tree = 1;
}

/// Most trees, the first of equals.
InventoryId default_reference(const ProjectState& state) {
  const Inventory* best = nullptr;
  for (const auto& inventory : state.inventories)
    if (best == nullptr || inventory->stems.size() > best->stems.size()) best = inventory.get();
  return best == nullptr ? InventoryId{} : best->id;
}

/// When the reference goes: of the inventories that are placed in its frame the one with most trees. None where there is none,
/// or where another one goes.
InventoryId next_reference(const ProjectState& state, InventoryId gone) {
  const Inventory* best = nullptr;
  for (const auto& inventory : state.inventories) {
    if (gone != state.reference || inventory->id == gone || !state.is_placed(inventory->id)) continue;
    if (best == nullptr || inventory->stems.size() > best->stems.size()) best = inventory.get();
  }
  return best == nullptr ? InventoryId{} : best->id;
}

std::shared_ptr<const Inventory>& slot(ProjectState& state, InventoryId id) {
  const auto found =
      std::find_if(state.inventories.begin(), state.inventories.end(), [&](const auto& i) { return i->id == id; });
  if (found == state.inventories.end()) throw std::logic_error("there is no such inventory");
  return *found;
}

template <class Edit>
CommandPtr edit_inventory(std::string label, InventoryId id, Edit edit) {
  return whole_state(std::move(label), [id, edit](ProjectState& state) {
    auto& place = slot(state, id);
    auto copy = std::make_shared<Inventory>(*place);
    edit(state, *copy);
    place = std::move(copy);
  });
}

}  // namespace

CommandPtr add_inventory(Inventory inventory) {
  std::string label = "Add inventory " + inventory.name;
  const auto shared = std::make_shared<const Inventory>(std::move(inventory));
  return whole_state(std::move(label), [shared](ProjectState& state) {
    auto added = std::make_shared<Inventory>(*shared);
    added->id = InventoryId{state.next_inventory++};
    added->name = free_name(state, added->name);
    state.inventories.push_back(std::move(added));
    if (state.alignments.empty() && state.matches.empty()) {
      const InventoryId before = std::exchange(state.reference, default_reference(state));
      if (before != state.reference && !is_spoken_of(state)) begin_ids_again(state);
    }
    assign_trees(state);
  });
}

CommandPtr remove_inventory(InventoryId id) {
  return whole_state("Remove inventory", [id](ProjectState& state) {
    slot(state, id);
    if (const InventoryId next = next_reference(state, id)) change_reference(state, next);  // the others keep their places
    bridge_over(state, id);
    std::erase_if(state.inventories, [&](const auto& i) { return i->id == id; });
    forget_matches_of(state, id);
    forget_positions_of(state, id);
    std::erase_if(state.pairs, [&](const PairReport& p) { return p.a == id || p.b == id; });
    state.alignments.erase(id);
    state.coverages.erase(id);
    state.dbh_error_m.erase(id);
    if (state.reference == id) {
      forget_alignment(state);
      state.georeference = {};
      state.reference = default_reference(state);
    }
    assign_trees(state);
    state.next_tree = state.trees.empty() ? 1 : state.trees.rbegin()->first.value + 1;
    state.next_inventory = 1;
    for (const auto& inventory : state.inventories) state.next_inventory = std::max(state.next_inventory, inventory->id.value + 1);
  });
}

CommandPtr rename_inventory(InventoryId id, std::string name) {
  std::string label = "Rename inventory to " + name;
  return edit_inventory(std::move(label), id, [name](const ProjectState& state, Inventory& inventory) {
    if (inventory.name != name) inventory.name = free_name(state, name);
  });
}

CommandPtr set_inventory_date(InventoryId id, std::optional<Date> date) {
  std::string label = date ? "Set date to " + to_string(*date) : "Clear date";
  return edit_inventory(std::move(label), id, [date](const ProjectState&, Inventory& inventory) {
    inventory.date = date;
    if (!date) return;
    for (Stem& stem : inventory.stems) stem.date.reset();  // growth goes by the date that the person gives
  });
}

CommandPtr replace_inventory(std::shared_ptr<const Inventory> inventory) {
  std::string label = "Replace the stems of " + inventory->name;
  return whole_state(std::move(label), [inventory](ProjectState& state) {
    const InventoryId id = inventory->id;
    auto& place = slot(state, id);
    auto copy = std::make_shared<Inventory>(*inventory);
    copy->name = place->name;
    copy->date = place->date;
    place = std::move(copy);
    forget_stems_of(state, id);
    assign_trees(state);
  });
}

CommandPtr set_reference(InventoryId id) {
  return whole_state("Set reference", [id](ProjectState& state) {
    slot(state, id);
    if (state.reference == id) return;
    if (state.is_placed(id)) return change_reference(state, id);
    forget_alignment(state);
    state.georeference = {};  // it was said about the other frame
    state.reference = id;
    assign_trees(state);
  });
}

}  // namespace stemwise
