#include <algorithm>

#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

const TreeRecord* selected_record(const WindowModel& m) {
  const auto it = m.document.state().trees.find(m.view.selected_tree);
  return it == m.document.state().trees.end() ? nullptr : &it->second;
}

/// The stem of `tree` to join with `other`: one of another survey, the one the person chose before.
StemRef partner_for(const ProjectState& state, TreeId tree, StemRef chosen, StemRef other) {
  if (chosen.index >= 0 && chosen.inventory != other.inventory && state.tree_of(chosen) == tree) return chosen;
  const auto it = state.trees.find(tree);
  if (it == state.trees.end()) return {};
  for (const StemRef& stem : it->second.stems) {
    if (stem.inventory != other.inventory) return stem;
  }
  return {};
}

void after_edit(WindowModel& m, StemRef stem) {
  m.view.tool = ui::Tool::select;
  m.view.link_from = {};
  m.view.selected_stem = stem;
  m.view.selected_tree = m.document.state().tree_of(stem);
}

}  // namespace

void select_tree(WindowModel& m, TreeId tree, bool fly) {
  const bool known = m.document.state().trees.contains(tree);
  m.view.selected_tree = known ? tree : TreeId{};
  if (!known || m.document.state().tree_of(m.view.selected_stem) != tree) m.view.selected_stem = {};
  if (known && fly) m.viewport.fly_to(tree, !m.view.reduce_motion);
}

void click_stem(WindowModel& m, const render::Pick& pick) {
  if (m.view.tool == ui::Tool::link) {
    link(m, m.view.link_from, pick.stem);
    return;
  }
  select_tree(m, pick.tree, false);
  m.view.selected_stem = pick.stem;
}

void go_to_doubtful(WindowModel& m, bool forward) {
  const std::vector<QueueRow>& queue = m.document.derived().tables.queue;
  if (queue.empty()) return;
  const auto n = static_cast<std::ptrdiff_t>(queue.size());
  const auto here = std::find_if(queue.begin(), queue.end(), [&](const QueueRow& row) { return row.tree == m.view.selected_tree; });
  const std::ptrdiff_t step = forward ? 1 : -1;
  std::ptrdiff_t at = here == queue.end() ? (forward ? -1 : 0) : here - queue.begin();
  m.view.step = ui::Step::review;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    at = (at + step + n) % n;
    const QueueRow& row = queue[static_cast<std::size_t>(at)];
    if (row.decided || row.tree == m.view.selected_tree) continue;
    select_tree(m, row.tree, true);
    return;
  }
  m.notices.add(Severity::note, "Every doubtful tree is decided");
}

void accept_selected(WindowModel& m) {
  const MatchRow* match = ui::match_to_decide(m.document.derived(), m.view.selected_tree);
  const TreeRow* tree = m.document.derived().tree(m.view.selected_tree);
  if (match != nullptr) {
    m.execute(accept_match(match->a, match->b, stamp_now()));
  } else if (tree != nullptr) {
    m.execute(set_fate(tree->tree, tree->fate, stamp_now()));
  }
}

void reject_selected(WindowModel& m) {
  const MatchRow* match = ui::match_to_decide(m.document.derived(), m.view.selected_tree);
  if (match == nullptr) return;
  const StemRef kept = match->a;
  m.execute(reject_match(match->a, match->b, stamp_now()));
  after_edit(m, kept);
}

void unlink_selected(WindowModel& m) {
  const StemRef stem = ui::unlink_target(m.document.state(), m.view);
  if (stem.index < 0) return;
  m.execute(unlink_stem(stem, stamp_now()));
  after_edit(m, stem);
}

void start_linking(WindowModel& m) {
  const TreeRecord* record = selected_record(m);
  if (record == nullptr || record->stems.empty()) return;
  const bool chosen = std::find(record->stems.begin(), record->stems.end(), m.view.selected_stem) != record->stems.end();
  m.view.link_from = chosen ? m.view.selected_stem : record->stems.back();
  m.view.tool = ui::Tool::link;
}

void link(WindowModel& m, StemRef from, StemRef to) {
  const ProjectState& state = m.document.state();
  const TreeId from_tree = state.tree_of(from);
  const TreeId to_tree = state.tree_of(to);
  if (from == to || (from_tree && from_tree == to_tree)) {
    m.notices.add(Severity::note, "These stems are one tree already");
    return;
  }
  if (from.inventory == to.inventory) {
    const StemRef other_from = partner_for(state, from_tree, from, to);
    const StemRef other_to = partner_for(state, to_tree, to, from);
    if (other_from.index >= 0) {
      from = other_from;
    } else if (other_to.index >= 0) {
      to = other_to;
    } else {
      m.notices.add(Severity::warning, "Both stems are of " + ui::survey_label(state, from.inventory) + ": a tree has one stem per survey");
      return;
    }
  }
  m.execute(link_stems(from, to, stamp_now()));
  after_edit(m, from);
}

void set_selected_fate(WindowModel& m, std::optional<Fate> fate) {
  if (selected_record(m) != nullptr) m.execute(set_fate(m.view.selected_tree, fate, stamp_now()));
}

}  // namespace stemwise
