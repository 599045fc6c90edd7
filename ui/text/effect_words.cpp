#include "ui/text/effect_words.hpp"

#include <algorithm>

#include "core/project/regroup_commands.hpp"

namespace stemwise::ui {
namespace {

/// "2018:4, 2023:9" of the tree's stems on one side of `first` by date.
std::string stems_from(const ProjectState& state, StemRef first, bool before) {
  const std::vector<InventoryId> order = state.by_date();
  const auto place = [&](StemRef stem) { return std::find(order.begin(), order.end(), stem.inventory) - order.begin(); };
  std::string words;
  for (const StemRef& stem : state.trees.at(state.tree_of(first)).stems) {
    if ((place(stem) < place(first)) == before) words += (words.empty() ? "" : ", ") + stem_label(state, stem);
  }
  return words;
}

std::string pair_words(const ProjectState& state, const MatchRow& match) { return stem_label(state, match.a) + " and " + stem_label(state, match.b); }

}  // namespace

std::string accept_words(const Frame& frame) {
  if (const MatchRow* match = match_to_decide(frame.derived, frame.view)) return pair_words(frame.state(), *match) + " are one tree; kept in later runs";
  const TreeRow* tree = frame.derived.tree(frame.view.selected_tree);
  return tree == nullptr ? "" : "The fate \"" + std::string(fate_label(tree->fate)) + "\" is right; kept in later runs";
}

std::string reject_words(const Frame& frame) {
  const MatchRow* match = match_to_decide(frame.derived, frame.view);
  return match == nullptr ? "" : pair_words(frame.state(), *match) + " are different trees; kept in later runs";
}

std::string unlink_words(const Frame& frame) {
  const StemRef stem = unlink_target(frame.state(), frame.view);
  return stem.index < 0 ? "" : stem_label(frame.state(), stem) + " leaves " + tree_label(frame.view.selected_tree) + " and becomes a tree of its own";
}

std::string split_words(const Frame& frame) {
  const StemRef first = unlink_target(frame.state(), frame.view);
  if (first.index < 0 || !why_not_split(frame.state(), first).empty()) return "";
  return tree_label(frame.view.selected_tree) + " keeps " + stems_from(frame.state(), first, true) + "; a new tree gets " + stems_from(frame.state(), first, false);
}

}  // namespace stemwise::ui
