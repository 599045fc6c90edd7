#include <algorithm>

#include "app/window/requests.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

/// The stem of the same tree in the reference: that is what a pair means to the alignment.
StemRef in_reference(const ProjectState& state, StemRef stem) {
  const auto tree = state.trees.find(state.tree_of(stem));
  if (tree == state.trees.end()) return stem;
  for (const StemRef& other : tree->second.stems) {
    if (other.inventory == state.reference) return other;
  }
  return stem;
}

}  // namespace

void pair_stem(WindowModel& m, StemRef stem) {
  const ProjectState& state = m.document.state();
  if (state.find(stem) == nullptr) return;
  if (m.view.link_from.index < 0) {
    m.view.link_from = stem;
    return;
  }
  const StemRef first = std::exchange(m.view.link_from, StemRef{});
  const bool forth = state.is_placed(first.inventory) && !state.is_placed(stem.inventory), back = state.is_placed(stem.inventory) && !state.is_placed(first.inventory);
  const StemRef known = in_reference(state, forth ? first : stem), other = forth ? stem : first;
  if (!(forth || back) || known.inventory != state.reference) {
    m.notices.add(Severity::warning, "A pair is one stem of " + ui::survey_label(state, state.reference) + " and one of the survey that is not aligned");
    return;
  }
  std::erase_if(m.view.pairs, [&](const auto& pair) { return pair.second == other || (pair.first == known && pair.second.inventory == other.inventory); });
  m.view.pairs.emplace_back(known, other);
}

void align_by_pairs(WindowModel& m) {
  m.view.tool = ui::Tool::select;
  m.view.link_from = {};
  run_alignment(m);
}

void forget_used_pairs(WindowModel& m) {
  const ProjectState& state = m.document.state();
  std::erase_if(m.view.pairs, [&](const auto& pair) { return state.find(pair.first) == nullptr || state.find(pair.second) == nullptr || state.is_placed(pair.second.inventory); });
}

}  // namespace stemwise
