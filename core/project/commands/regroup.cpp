#include "core/project/regroup_commands.hpp"

#include <algorithm>

#include "core/project/commands/edit_command.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {
namespace {

void must(const std::string& why_not) {
  if (!why_not.empty()) throw std::logic_error(why_not);
}

std::string survey_of(const ProjectState& state, InventoryId id) {
  const Inventory* inventory = state.find(id);
  return inventory == nullptr ? "one survey" : inventory->name;
}

/// The tree's stems that are surveyed before `first`, and those from it on.
std::pair<std::vector<StemRef>, std::vector<StemRef>> parts_at(const ProjectState& state, StemRef first) {
  const std::vector<InventoryId> order = state.by_date();
  const auto place = [&](StemRef stem) { return std::find(order.begin(), order.end(), stem.inventory) - order.begin(); };
  std::pair<std::vector<StemRef>, std::vector<StemRef>> parts;
  for (const StemRef& stem : state.trees.at(state.tree_of(first)).stems) (place(stem) < place(first) ? parts.first : parts.second).push_back(stem);
  return parts;
}

}  // namespace

std::string why_not_swap(const ProjectState& state, StemRef a, StemRef b) {
  const TreeId tree_a = state.tree_of(a), tree_b = state.tree_of(b);
  if (!tree_a || !tree_b) return "Only stems of aligned surveys belong to trees";
  if (a.inventory != b.inventory) return "Only two stems of one survey can change places";
  if (tree_a == tree_b) return "It is the same stem";
  if (state.trees.at(tree_a).stems.size() < 2 && state.trees.at(tree_b).stems.size() < 2) return "Both trees were seen in this survey only: there is nothing to swap";
  return "";
}

CommandPtr swap_stems(StemRef a, StemRef b, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    const ProjectState& state = editor.state();
    must(why_not_swap(state, a, b));
    const TreeId tree_a = state.tree_of(a), tree_b = state.tree_of(b);
    editor.log(stamp, "Swap " + stem_label(state, a) + " and " + stem_label(state, b), tree_label(tree_a) + ", " + tree_label(tree_b),
               tree_label(tree_b) + ", " + tree_label(tree_a));
    editor.exchange(a, b);
    editor.note_edit(tree_a, stamp);
    editor.note_edit(tree_b, stamp);
  });
}

std::string why_not_split(const ProjectState& state, StemRef first) {
  if (!state.tree_of(first)) return "Only stems of aligned surveys belong to trees";
  if (state.trees.at(state.tree_of(first)).stems.size() < 2) return "The tree was seen in one survey only: there is nothing to split";
  if (parts_at(state, first).first.empty()) return "Choose a later sighting: the tree is split before it";
  return "";
}

CommandPtr split_tree(StemRef first, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    const ProjectState& state = editor.state();
    must(why_not_split(state, first));
    const TreeId tree = state.tree_of(first);
    const auto [before, after] = parts_at(state, first);
    editor.log(stamp, "Split " + tree_label(tree) + " at " + stem_label(state, first), std::to_string(before.size() + after.size()) + " stems",
               std::to_string(before.size()) + " and " + std::to_string(after.size()));
    const TreeId other = editor.split(tree, after, {ordered(before.back(), first)});
    editor.note_edit(other, stamp);
    editor.note_edit(tree, stamp);
  });
}

std::string why_not_merge(const ProjectState& state, TreeId a, TreeId b) {
  const auto first = state.trees.find(a), second = state.trees.find(b);
  if (first == state.trees.end() || second == state.trees.end()) return "Only stems of aligned surveys belong to trees";
  if (a == b) return "It is the same tree";
  for (const StemRef& stem : first->second.stems) {
    for (const StemRef& other : second->second.stems) {
      if (stem.inventory == other.inventory) return "Both were seen in " + survey_of(state, stem.inventory) + ": a tree has one stem per survey";
    }
  }
  return "";
}

CommandPtr merge_trees(TreeId a, TreeId b, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    const ProjectState& state = editor.state();
    must(why_not_merge(state, a, b));
    const TreeId into = std::min(a, b), from = std::max(a, b);
    const std::vector<StemRef> kept = state.trees.at(into).stems, added = state.trees.at(from).stems;
    editor.log(stamp, "Merge " + tree_label(into) + " and " + tree_label(from), "two trees", tree_label(into));
    editor.merge(into, from);
    for (const StemRef& one : kept)
      for (const StemRef& other : added) editor.set_match_state(one, other, MatchState::linked);
    editor.note_edit(into, stamp);
  });
}

}  // namespace stemwise
