#include <algorithm>

#include "app/window/click_effect.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "core/project/regroup_commands.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

const TreeRecord* selected_record(const WindowModel& m) {
  const auto it = m.document.state().trees.find(m.view.selected_tree);
  return it == m.document.state().trees.end() ? nullptr : &it->second;
}

void after_edit(WindowModel& m, StemRef stem) {
  m.view.tool = ui::Tool::select;
  m.view.link_from = {};
  m.view.selected_stem = stem;
  m.view.selected_tree = m.document.state().tree_of(stem);
}

/// The later stem of the match that is in doubt: what Unlink takes out, and whose match Accept and Reject decide on.
StemRef doubtful_stem(const WindowModel& m, TreeId tree) {
  const ui::Derived& derived = m.document.derived();
  const QueueRow* doubt = derived.doubt(tree);
  return doubt != nullptr && doubt->match ? derived.tables.matches[*doubt->match].b : StemRef{};
}

void show_tree(WindowModel& m, TreeId tree, bool fly, StemRef stem) {
  const ProjectState& state = m.document.state();
  const bool known = state.trees.contains(tree);
  m.view.group.clear();
  m.view.selected_tree = known ? tree : TreeId{};
  if (stem.index < 0) stem = doubtful_stem(m, tree);
  m.view.selected_stem = known && stem.index >= 0 && state.tree_of(stem) == tree ? stem : StemRef{};
  if (known && fly) m.viewport.fly_to(tree, !m.view.reduce_motion);
}

}  // namespace

void select_tree(WindowModel& m, TreeId tree, bool fly, StemRef stem) {
  show_tree(m, tree, fly, stem);
  const QueueRow* doubt = m.document.derived().doubt(m.view.selected_tree);
  if (doubt != nullptr && !doubt->decided) m.walk.stand_on(*doubt, true);
}

void click_stem(WindowModel& m, const render::Pick& pick) {
  if (m.view.tool == ui::Tool::link || m.view.tool == ui::Tool::swap || m.view.tool == ui::Tool::merge) {
    use_tool(m, m.view.tool, m.view.link_from, pick.stem);
    return;
  }
  if (m.view.tool == ui::Tool::pair) return pair_stem(m, pick.stem);
  // The stems of one tree lie over each other: the first click means the tree and what is in doubt about it, another one the stem.
  const QueueRow* doubt = m.document.derived().doubt(pick.tree);
  const bool first = pick.tree && pick.tree != m.view.selected_tree && doubt != nullptr && !doubt->decided && m.view.hidden.empty();
  select_tree(m, pick.tree, false, first ? StemRef{} : pick.stem);
  if (!pick.tree) m.view.selected_stem = pick.stem;
}

void go_to_doubtful(WindowModel& m, bool forward) {
  std::vector<QueueRow> queue;  // what the filters of the queue show: N keeps to it
  for (const QueueRow& row : m.document.derived().tables.queue) {
    if (ui::passes(m.view.queue, m.view, m.document.derived(), row)) queue.push_back(row);
  }
  const auto to = forward ? m.walk.next(queue) : m.walk.previous(queue);
  m.view.step = ui::Step::review;
  if (!to) {
    const bool part = m.view.queue.hides_rows() || m.view.only_fate;
    m.notices.add(Severity::note, part ? "Every doubtful tree that the queue's filters show is decided" : "Every doubtful tree is decided");
    return;
  }
  m.walk.stand_on(queue[*to], !forward);
  show_tree(m, queue[*to].tree, true, {});
}

void accept_selected(WindowModel& m) {
  if (!m.view.group.empty()) return accept_group(m);
  const MatchRow* match = ui::match_to_decide(m.document.derived(), m.view);
  const TreeRow* tree = m.document.derived().tree(m.view.selected_tree);
  m.walk.decided(m.view.selected_tree);
  if (match != nullptr) {
    m.execute(accept_match(match->a, match->b, stamp_now()));
  } else if (tree != nullptr) {
    m.execute(set_fate(tree->tree, tree->fate, stamp_now()));
  }
}

void reject_selected(WindowModel& m) {
  if (!m.view.group.empty()) return reject_group(m);
  const MatchRow* match = ui::match_to_decide(m.document.derived(), m.view);
  if (match == nullptr) return;
  m.walk.decided(m.view.selected_tree);
  const StemRef kept = match->a;
  m.execute(reject_match(match->a, match->b, stamp_now()));
  after_edit(m, kept);
}

void unlink_selected(WindowModel& m) {
  const StemRef stem = ui::unlink_target(m.document.state(), m.view);
  if (stem.index < 0) return;
  m.walk.decided(m.view.selected_tree);
  m.execute(unlink_stem(stem, stamp_now()));
  after_edit(m, stem);
}

void start_tool(WindowModel& m, ui::Tool tool) {
  const TreeRecord* record = selected_record(m);
  if (record == nullptr || record->stems.empty()) return;
  const bool chosen = std::find(record->stems.begin(), record->stems.end(), m.view.selected_stem) != record->stems.end();
  m.view.link_from = chosen ? m.view.selected_stem : record->stems.back();
  m.view.tool = tool;
}

void split_selected(WindowModel& m) {
  const StemRef first = ui::unlink_target(m.document.state(), m.view);
  if (first.index < 0 || !why_not_split(m.document.state(), first).empty()) return;
  m.walk.decided(m.view.selected_tree);
  m.execute(split_tree(first, stamp_now()));
  after_edit(m, first);
}

void use_tool(WindowModel& m, ui::Tool tool, StemRef from, StemRef to) {
  const ClickEffect effect = effect_of_click(m.document.state(), tool, from, to);
  if (!effect.possible) {
    m.notices.add(Severity::warning, effect.words);
    return;
  }
  m.execute(command_of(m.document.state(), tool, effect, stamp_now()));
  after_edit(m, effect.from);
}

void set_selected_fate(WindowModel& m, std::optional<Fate> fate) {
  if (!m.view.group.empty()) return set_group_fate(m, fate);
  if (selected_record(m) != nullptr) m.execute(set_fate(m.view.selected_tree, fate, stamp_now()));
}

}  // namespace stemwise
