#include "ui/panels/conflict_table.hpp"

#include <imgui.h>

#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::string attribute_words(const FusionConflict& conflict) { return conflict.attribute == "dbh" ? "DBH, cm" : conflict.attribute; }

/// "2015 24.5, 2019 21.7".
std::string values_words(const Frame& frame, const FusionConflict& conflict) {
  std::string words;
  for (const auto& [survey, value] : conflict.values) words += (words.empty() ? "" : ", ") + survey_label(frame.state(), survey) + ": " + value;
  return words;
}

std::string source_words(const Frame& frame, const FusionConflict& conflict) {
  const std::string from = conflict.source ? survey_label(frame.state(), conflict.source) : "several surveys";
  return from + (conflict.by_hand ? ", by hand" : "");
}

}  // namespace

void ConflictTable::filter(const Frame& frame) {
  if (revision_ == frame.derived.revision && filtered_by_ == text_) return;
  revision_ = frame.derived.revision;
  filtered_by_ = text_;
  rows_.clear();
  for (std::size_t i = 0; i < frame.derived.conflicts.size(); ++i) {
    const FusionConflict& c = frame.derived.conflicts[i];
    if ((tree_label(c.tree) + " " + attribute_words(c) + " " + values_words(frame, c)).find(text_) != std::string::npos) rows_.push_back(i);
  }
}

void ConflictTable::draw(Widgets& w, Frame& frame) {
  filter(frame);
  const std::vector<FusionConflict>& all = frame.derived.conflicts;
  if (!all.empty()) {
    draw_filter(w, "conflicts/filter", text_, "Filter by tree, attribute or value", "The value that is kept can be chosen per tree in step 4");
  }
  TableView table;
  table.path = "conflicts";
  table.columns = {{"Tree", 0.8f}, {"What", 0.8f}, {"Values", 3.0f}, {"Kept", 1.0f}, {"From", 1.3f}};
  table.least_width = w.px(500);
  table.rows = rows_.size();
  table.cell = [&](std::size_t row, std::size_t column) -> TableCell {
    const FusionConflict& c = all[rows_[row]];
    const std::string cells[] = {tree_label(c.tree), attribute_words(c), values_words(frame, c), c.kept, source_words(frame, c)};
    return {cells[column], c.by_hand ? Tone::secondary : Tone::text};
  };
  table.selected = [&](std::size_t row) { return all[rows_[row]].tree == frame.view.selected_tree; };
  table.clicked = [&](std::size_t row) { frame.requests.emit(request::SelectTree{all[rows_[row]].tree}); };
  table.empty_text = frame.tables().inventories.size() < 2 ? "Conflicts appear here when surveys are aligned." : all.empty() ? "The surveys agree on every merged tree." : "No conflict fits the filter.";
  draw_table(w, table);
}

}  // namespace stemwise::ui
