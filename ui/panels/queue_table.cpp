#include "ui/panels/queue_table.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

/// What a row is about: the match in doubt, or the tree's last two surveys.
struct Compared {
  std::string surveys = dash;
  std::optional<double> before_m, after_m;
  std::optional<double> change_m() const { return before_m && after_m ? std::optional<double>(*after_m - *before_m) : std::nullopt; }
};

Compared compared(const Frame& frame, const QueueRow& row) {
  const Tables& t = frame.tables();
  const auto label = [&](InventoryId id) { return survey_label(frame.state(), id); };
  if (row.match) {
    const MatchRow& m = t.matches[*row.match];
    return {label(m.a.inventory) + ", " + label(m.b.inventory), m.dbh_a_m, m.dbh_b_m};
  }
  const TreeRow* tree = frame.derived.tree(row.tree);
  const std::size_t count = t.inventories.size();
  if (tree == nullptr || count < 2 || tree->dbh_per_inventory_m.size() < count) return {};
  return {label(t.inventories[count - 2]) + ", " + label(t.inventories[count - 1]), tree->dbh_per_inventory_m[count - 2], tree->dbh_per_inventory_m[count - 1]};
}

TableCell cell_of(const Frame& frame, const QueueRow& row, std::size_t column) {
  const Tone tone = row.decided ? Tone::secondary : Tone::text;
  switch (column) {
    case 0: return {tree_label(row.tree), tone};
    case 1: return {fixed(row.doubt, 2), tone};
    case 2: return {compared(frame, row).surveys, tone};
    case 3: return {dbh_text(compared(frame, row).before_m), tone};
    case 4: return {dbh_text(compared(frame, row).after_m), tone};
    case 5: {
      const auto change = compared(frame, row).change_m();
      return {change_text(change), change && *change < -0.01 && !row.decided ? Tone::warning : tone};
    }
    default: return {row.decided ? "decided: " + row.why : row.why, tone};
  }
}

}  // namespace

void QueueTable::filter(const Frame& frame) {
  wanted_.revision = frame.derived.revision;
  wanted_.fate = frame.view.only_fate;
  if (wanted_ == key_) return;
  key_ = wanted_;
  rows_.clear();
  const Tables& t = frame.tables();
  for (std::size_t i = 0; i < t.queue.size(); ++i) {
    const QueueRow& row = t.queue[i];
    if (key_.open_only && row.decided && row.tree != frame.view.selected_tree) continue;
    const TreeRow* tree = frame.derived.tree(row.tree);
    if (key_.fate && (tree == nullptr || tree->fate != *key_.fate)) continue;
    if (!key_.text.empty() && (tree_label(row.tree) + " " + row.why).find(key_.text) == std::string::npos) continue;
    rows_.push_back(i);
  }
}

void QueueTable::draw(Widgets& w, Frame& frame) {
  filter(frame);
  const Tables& t = frame.tables();
  if (!t.queue.empty()) {
    w.checkbox("queue/open_only", "Undecided only", wanted_.open_only);
    ImGui::SameLine(0, w.px(16));
    w.input("queue/filter", wanted_.text, {.hint = "Filter by tree or reason", .width = w.px(220)});
  }
  TableView table;
  table.path = "queue";
  table.columns = {{"Tree", 0.8f},           {"Doubt", 0.6f, true},      {"Surveys", 1.0f}, {"cm before", 0.9f, true},
                   {"cm after", 0.8f, true}, {"Change, cm", 0.9f, true}, {"Why", 2.9f}};
  table.rows = rows_.size();
  table.cell = [&](std::size_t row, std::size_t column) { return cell_of(frame, t.queue[rows_[row]], column); };
  table.selected = [&](std::size_t row) { return t.queue[rows_[row]].tree == frame.view.selected_tree; };
  table.clicked = [&](std::size_t row) { frame.requests.emit(request::SelectTree{t.queue[rows_[row]].tree}); };
  table.empty_text = t.inventories.size() < 2 ? "The queue fills when surveys are aligned: press Align in step 2."
                     : t.queue.empty() ? "No tree is in doubt." : "Every doubtful tree is decided.";
  if (shown_tree_ != frame.view.selected_tree) {
    shown_tree_ = frame.view.selected_tree;
    const auto it = std::find_if(rows_.begin(), rows_.end(), [&](std::size_t i) { return t.queue[i].tree == shown_tree_; });
    if (it != rows_.end()) table.scroll_to = static_cast<std::size_t>(it - rows_.begin());
  }
  draw_table(w, table);
}

}  // namespace stemwise::ui
