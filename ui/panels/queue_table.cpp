#include "ui/panels/queue_table.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

/// DBH in the n-th last survey shown (0: the last).
std::optional<double> dbh_in(const TreeRow* tree, std::size_t from_last) {
  if (tree == nullptr || tree->dbh_per_inventory_m.size() <= from_last) return std::nullopt;
  return tree->dbh_per_inventory_m[tree->dbh_per_inventory_m.size() - 1 - from_last];
}

std::optional<double> change_of(const TreeRow* tree) {
  const auto before = dbh_in(tree, 1), after = dbh_in(tree, 0);
  return before && after ? std::optional<double>(*after - *before) : std::nullopt;
}

TableCell cell_of(const Frame& frame, const QueueRow& row, std::size_t column) {
  const TreeRow* tree = frame.derived.tree(row.tree);
  const Tone tone = row.decided ? Tone::secondary : Tone::text;
  switch (column) {
    case 0: return {tree_label(row.tree), tone};
    case 1: return {fixed(row.doubt, 2), tone};
    case 2: return {dbh_text(dbh_in(tree, 1)), tone};
    case 3: return {dbh_text(dbh_in(tree, 0)), tone};
    case 4: {
      const auto change = change_of(tree);
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
  const auto head = [&](std::size_t from_last) {
    return t.inventories.size() > from_last ? "DBH " + survey_label(frame.state(), t.inventories[t.inventories.size() - 1 - from_last]) : std::string("DBH");
  };
  TableView table;
  table.path = "queue";
  table.columns = {{"Tree", 0.8f, false}, {"Doubt", 0.6f, true}, {head(1) + ", cm", 1.15f, true}, {head(0) + ", cm", 1.15f, true}, {"Change, cm", 1.0f, true}, {"Why", 2.9f, false}};
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
