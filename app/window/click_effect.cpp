#include "app/window/click_effect.hpp"

#include <algorithm>

#include "core/project/commands.hpp"
#include "core/project/regroup_commands.hpp"
#include "core/survey/tables.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

/// The tree's stem in this survey, or in any but this one; none.
StemRef stem_in(const ProjectState& state, TreeId tree, InventoryId inventory, bool in) {
  const auto it = state.trees.find(tree);
  if (it == state.trees.end()) return {};
  const auto at = std::find_if(it->second.stems.begin(), it->second.stems.end(), [&](StemRef s) { return (s.inventory == inventory) == in; });
  return at == it->second.stems.end() ? StemRef{} : *at;
}

/// "; 2023:44 leaves T-00012" for the stems that have to make room.
std::string leavers(const ProjectState& state, StemRef from, StemRef to) {
  std::string words;
  const StemRef old_to = stem_in(state, state.tree_of(from), to.inventory, true), old_from = stem_in(state, state.tree_of(to), from.inventory, true);
  if (old_to.index >= 0) words += "; " + ui::stem_label(state, old_to) + " leaves " + tree_label(state.tree_of(from));
  if (old_from.index >= 0) words += "; " + ui::stem_label(state, old_from) + " leaves " + tree_label(state.tree_of(to));
  return words;
}

ClickEffect link_effect(const ProjectState& state, StemRef from, StemRef to) {
  const TreeId from_tree = state.tree_of(from), to_tree = state.tree_of(to);
  if (from == to || (from_tree && from_tree == to_tree)) return {from, to, "These stems are one tree already"};
  if (from.inventory == to.inventory) {  // another stem of one of the two trees is meant
    const StemRef other_from = stem_in(state, from_tree, to.inventory, false), other_to = stem_in(state, to_tree, from.inventory, false);
    if (other_from.index >= 0) {
      from = other_from;
    } else if (other_to.index >= 0) {
      to = other_to;
    } else {
      return {from, to, "Both stems are of " + ui::survey_label(state, from.inventory) + ": a tree has one stem per survey"};
    }
  }
  return {from, to, "Link " + ui::stem_label(state, from) + " and " + ui::stem_label(state, to) + leavers(state, from, to), true};
}

ClickEffect swap_effect(const ProjectState& state, StemRef from, StemRef to) {
  if (to.inventory != from.inventory) {
    const StemRef same = stem_in(state, state.tree_of(to), from.inventory, true);
    if (same.index < 0) return {from, to, "This tree was not seen in " + ui::survey_label(state, from.inventory) + ": nothing to swap with"};
    to = same;
  }
  const std::string why_not = why_not_swap(state, from, to);
  if (!why_not.empty()) return {from, to, why_not};
  return {from, to, "Swap " + ui::stem_label(state, from) + " and " + ui::stem_label(state, to), true};
}

ClickEffect merge_effect(const ProjectState& state, StemRef from, StemRef to) {
  const std::string why_not = why_not_merge(state, state.tree_of(from), state.tree_of(to));
  if (!why_not.empty()) return {from, to, why_not};
  return {from, to, "Merge " + tree_label(state.tree_of(from)) + " and " + tree_label(state.tree_of(to)), true};
}

}  // namespace

ClickEffect effect_of_click(const ProjectState& state, ui::Tool tool, StemRef from, StemRef to) {
  if (!state.tree_of(from) || !state.tree_of(to)) return {from, to, "Only stems of aligned surveys belong to trees"};
  if (tool == ui::Tool::swap) return swap_effect(state, from, to);
  return tool == ui::Tool::merge ? merge_effect(state, from, to) : link_effect(state, from, to);
}

CommandPtr command_of(const ProjectState& state, ui::Tool tool, const ClickEffect& effect, EditStamp stamp) {
  if (tool == ui::Tool::swap) return swap_stems(effect.from, effect.to, std::move(stamp));
  if (tool == ui::Tool::merge) return merge_trees(state.tree_of(effect.from), state.tree_of(effect.to), std::move(stamp));
  return link_stems(effect.from, effect.to, std::move(stamp));
}

}  // namespace stemwise
