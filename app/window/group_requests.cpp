#include <algorithm>

#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

std::string of_trees(const WindowModel& m) { return ui::plural(static_cast<std::int64_t>(m.view.group.size()), "tree", "trees"); }

void run_all(WindowModel& m, const std::string& what, std::vector<CommandPtr> commands) {
  if (commands.empty()) {
    m.notices.add(Severity::note, what + ": there is nothing left to decide");
    return;
  }
  for (const TreeId tree : m.view.group) m.walk.decided(tree);
  m.execute(group(what, std::move(commands)));
  const auto gone = [&](TreeId tree) { return !m.document.state().trees.contains(tree); };
  std::erase_if(m.view.group, gone);
}

}  // namespace

void select_group(WindowModel& m, std::vector<TreeId> trees) {
  std::erase_if(trees, [&](TreeId tree) { return !m.document.state().trees.contains(tree); });
  std::sort(trees.begin(), trees.end());
  trees.erase(std::unique(trees.begin(), trees.end()), trees.end());
  if (trees.size() == 1) {
    m.view.group.clear();
    select_tree(m, trees.front(), false);
    return;
  }
  if (!trees.empty()) {
    m.view.selected_tree = {};
    m.view.selected_stem = {};
  }
  m.view.group = std::move(trees);
}

void toggle_in_group(WindowModel& m, TreeId tree) {
  std::vector<TreeId> trees = m.view.group;
  if (trees.empty() && m.view.selected_tree) trees.push_back(m.view.selected_tree);
  const auto at = std::find(trees.begin(), trees.end(), tree);
  at == trees.end() ? trees.push_back(tree) : static_cast<void>(trees.erase(at));
  select_group(m, std::move(trees));
}

void accept_group(WindowModel& m) {
  const ui::Derived& derived = m.document.derived();
  std::vector<CommandPtr> commands;
  for (const TreeId tree : m.view.group) {
    for (const MatchRow* match : derived.matches_of(tree)) {
      if (match->state == MatchState::automatic) commands.push_back(accept_match(match->a, match->b, stamp_now()));
    }
    const QueueRow* doubt = derived.doubt(tree);
    const TreeRow* row = derived.tree(tree);
    if (doubt != nullptr && !doubt->decided && !doubt->match && row != nullptr) commands.push_back(set_fate(tree, row->fate, stamp_now()));
  }
  run_all(m, "Accept " + of_trees(m), std::move(commands));
}

void reject_group(WindowModel& m) {
  const ui::Derived& derived = m.document.derived();
  std::vector<CommandPtr> commands;
  for (const TreeId tree : m.view.group) {
    const QueueRow* doubt = derived.doubt(tree);
    if (doubt == nullptr || doubt->decided || !doubt->match) continue;  // only what is in doubt: the rest stays as it is
    const MatchRow& match = derived.tables.matches[*doubt->match];
    commands.push_back(reject_match(match.a, match.b, stamp_now()));
  }
  run_all(m, "Reject the doubtful matches of " + of_trees(m), std::move(commands));
}

void set_group_fate(WindowModel& m, std::optional<Fate> fate) {
  std::int64_t contradicted = 0;
  std::vector<CommandPtr> commands;
  for (const TreeId tree : m.view.group) {
    const auto it = m.document.state().trees.find(tree);
    if (it == m.document.state().trees.end() || it->second.fate_by_hand == fate) continue;
    if (fate && !why_not_fate(m.document.state(), tree, *fate).empty()) ++contradicted;
    else commands.push_back(set_fate(tree, fate, stamp_now()));
  }
  if (contradicted > 0) {
    m.notices.add(Severity::warning, ui::plural(contradicted, "tree was", "trees were") + " left as they are: their sightings say that they are not " + fate_in_sentence(*fate));
  }
  run_all(m, (fate ? "Mark as " + fate_in_sentence(*fate) : std::string("Clear fate")) + ": " + of_trees(m), std::move(commands));
}

void toggle_queue_region(WindowModel& m) {
  std::optional<ui::MapRegion>& region = m.view.queue.region;
  if (region) {
    region.reset();
    return;
  }
  region = m.viewport.map_region();
  m.view.tab = ui::BottomTab::queue;
}

}  // namespace stemwise
