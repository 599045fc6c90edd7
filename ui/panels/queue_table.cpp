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

/// A tree that is gone: its last DBH, and nothing in the survey after that. Else its last two sightings.
Compared compared(const Frame& frame, const QueueRow& row) {
  const Tables& t = frame.tables();
  const auto label = [&](std::size_t i) { return survey_label(frame.state(), t.inventories[i]); };
  if (row.match) {
    const MatchRow& m = t.matches[*row.match];
    return {survey_label(frame.state(), m.a.inventory) + ", " + survey_label(frame.state(), m.b.inventory), m.dbh_a_m, m.dbh_b_m};
  }
  const TreeRow* tree = frame.derived.tree(row.tree);
  const std::vector<const ObservationRow*> seen = frame.derived.sightings(row.tree);
  if (tree == nullptr || seen.empty() || tree->dbh_per_inventory_m.size() < t.inventories.size()) return {};
  const auto place = [&](InventoryId id) { return static_cast<std::size_t>(std::find(t.inventories.begin(), t.inventories.end(), id) - t.inventories.begin()); };
  const std::size_t last = place(seen.back()->stem.inventory);
  if (last + 1 < t.inventories.size()) return {label(last) + ", " + label(last + 1), tree->dbh_per_inventory_m[last], std::nullopt};
  const std::size_t before = seen.size() >= 2 ? place(seen[seen.size() - 2]->stem.inventory) : last > 0 ? last - 1 : last;
  if (before >= last) return {label(last), std::nullopt, tree->dbh_per_inventory_m[last]};
  return {label(before) + ", " + label(last), tree->dbh_per_inventory_m[before], tree->dbh_per_inventory_m[last]};
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
  const ViewState& view = frame.view;
  const Key wanted{frame.derived.revision, view.queue, view.only_fate, view.selected_tree};
  if (wanted == key_) return;
  key_ = wanted;
  rows_.clear();
  const Tables& t = frame.tables();
  for (std::size_t i = 0; i < t.queue.size(); ++i) {
    if (view.queue.open_only && t.queue[i].decided && t.queue[i].tree != view.selected_tree) continue;
    if (passes(view.queue, view, frame.derived, t.queue[i])) rows_.push_back(i);
  }
  progress_ = progress_of(view.queue, view, frame.derived);
}

void QueueTable::draw_filters(Widgets& w, Frame& frame) {
  QueueFilter& filter = frame.view.queue;
  const Rect line = w.next_rect(w.available_width(), w.px(28));
  const bool narrow = line.width < w.px(700);
  std::vector<std::string> kinds{"All reasons"};
  for (std::size_t i = 0; i < doubt_kind_count; ++i) kinds.emplace_back(doubt_label(static_cast<DoubtKind>(i)));
  int kind = filter.kind ? static_cast<int>(*filter.kind) + 1 : 0;
  if (w.combo("queue/reason", kinds, kind, w.px(narrow ? 120 : 158))) filter.kind = kind == 0 ? std::optional<DoubtKind>{} : static_cast<DoubtKind>(kind - 1);
  ImGui::SameLine(0, w.px(8));
  const std::vector<InventoryId>& surveys = frame.tables().inventories;
  std::vector<std::string> names{"All surveys"};
  for (const InventoryId id : surveys) names.push_back(survey_label(frame.state(), id));
  const auto at = std::find(surveys.begin(), surveys.end(), filter.inventory);
  int survey = at == surveys.end() ? 0 : static_cast<int>(at - surveys.begin()) + 1;
  if (w.combo("queue/survey", names, survey, w.px(narrow ? 96 : 116))) filter.inventory = survey == 0 ? InventoryId{} : surveys[static_cast<std::size_t>(survey - 1)];
  ImGui::SameLine(0, w.px(8));
  const std::string hint = "Only trees in the part of the map that is shown now; again: all  (" + to_string(action(ActionId::review_region).chord) + ")";
  const float region = w.px(narrow ? 68 : 92);
  if (w.button_in(w.next_rect(region, w.px(28)), "queue/region", narrow ? "Region" : "This region", {.active = filter.region.has_value(), .tooltip = hint})) frame.requests.run(ActionId::review_region);
  ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + w.px(8), line.y});
  w.input("queue/filter", filter.text, {.hint = narrow ? "Filter" : "Filter by tree or reason", .width = w.px(narrow ? 76 : 164)});
  ImGui::SameLine(0, w.px(12));
  w.checkbox("queue/open_only", narrow ? "Undecided" : "Undecided only", filter.open_only, "Off: decided rows are shown too");
  draw_progress(w, frame);
}

/// "212 of 340 decided" at the right, of what the filters show.
void QueueTable::draw_progress(Widgets& w, const Frame& frame) {
  const ImVec2 after = ImGui::GetItemRectMax();
  const ImVec2 origin = ImGui::GetWindowPos();
  const float right = origin.x + ImGui::GetWindowWidth() - w.px(8);
  const bool part = frame.view.queue.hides_rows() || frame.view.only_fate.has_value();
  const std::string text = count_text(progress_.decided) + " of " + count_text(progress_.all) + (part ? " decided here" : " decided");
  const float width = w.text_width(text, TextRole::table) + 2;
  const Rect words{right - width, after.y - w.px(26), width, w.px(18)};
  w.record("queue/progress", words, text);
  if (words.x < after.x + w.px(4)) return;  // the step bar above says it too
  w.text_in(words, text, TextRole::table, Tone::secondary, Align::right);
  if (progress_.all > 0) w.progress_bar({words.x, words.bottom() + w.px(1), width, w.px(4)}, static_cast<double>(progress_.decided) / progress_.all);
}

void QueueTable::draw(Widgets& w, Frame& frame) {
  filter(frame);
  const Tables& t = frame.tables();
  if (!t.queue.empty()) draw_filters(w, frame);
  TableView table;
  table.path = "queue";
  table.columns = {{"Tree", 0.83f},           {"Doubt", 0.6f, true},      {"Surveys", 1.03f}, {"Before, cm", 0.9f, true},
                   {"After, cm", 0.8f, true}, {"Change, cm", 0.95f, true}, {"Why", 2.76f}};
  table.least_width = w.px(600);
  table.rows = rows_.size();
  table.cell = [&](std::size_t row, std::size_t column) { return cell_of(frame, t.queue[rows_[row]], column); };
  table.selected = [&](std::size_t row) {
    const TreeId tree = t.queue[rows_[row]].tree;
    return tree == frame.view.selected_tree || std::binary_search(frame.view.group.begin(), frame.view.group.end(), tree);
  };
  table.clicked = [&](std::size_t row) { frame.requests.emit(request::SelectTree{t.queue[rows_[row]].tree}); };
  const bool part = frame.view.queue.hides_rows() || frame.view.only_fate.has_value();
  table.empty_text = t.inventories.size() < 2 ? "The queue fills when surveys are aligned: press Align in step 2."
                     : t.queue.empty()        ? "No tree is in doubt."
                     : part                   ? "No row fits the filters (Shift+N clears them)."
                                              : "Every doubtful tree is decided.";
  if (shown_tree_ != frame.view.selected_tree) {
    shown_tree_ = frame.view.selected_tree;
    const auto it = std::find_if(rows_.begin(), rows_.end(), [&](std::size_t i) { return t.queue[i].tree == shown_tree_; });
    if (it != rows_.end()) table.scroll_to = static_cast<std::size_t>(it - rows_.begin());
  }
  draw_table(w, table);
}

}  // namespace stemwise::ui
