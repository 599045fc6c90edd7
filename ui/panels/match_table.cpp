#include "ui/panels/match_table.hpp"

#include <imgui.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

const std::vector<Column>& columns() {
  static const std::vector<Column> all{{"Tree", 0.9f},           {"Earlier stem", 1.25f},  {"Later stem", 1.25f},    {"Distance, m", 1.2f, true},
                                       {"Before, cm", 1.1f, true}, {"After, cm", 1.0f, true}, {"Change, cm", 1.1f, true}, {"cm a year", 1.0f, true},
                                       {"Class", 1.1f},           {"Confidence", 1.3f, true, true}, {"State", 1.0f}};
  return all;
}

/// Of a narrow window only those columns that leave room to read which stems are meant.
std::vector<std::size_t> columns_that_fit(Widgets& w) {
  if (w.available_width() < w.px(820)) return {0, 1, 2, 3, 4, 5, 6, 9};
  std::vector<std::size_t> all(columns().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

const char* change_words(ChangeClass change) {
  switch (change) {
    case ChangeClass::grew: return "grew";
    case ChangeClass::shrank: return "shrank";
    case ChangeClass::within_error: return "within error";
    case ChangeClass::unknown: return "unknown";
  }
  return "";
}

TableCell cell_of(const ProjectState& state, const MatchRow& m, std::size_t column) {
  const Tone tone = m.state == MatchState::rejected ? Tone::secondary : Tone::text;
  switch (column) {
    case 0: return {tree_label(m.tree), tone};
    case 1: return {stem_label(state, m.a), tone};
    case 2: return {stem_label(state, m.b), tone};
    case 3: return {fixed(m.distance_m, 2), tone};
    case 4: return {dbh_text(m.dbh_a_m), tone};
    case 5: return {dbh_text(m.dbh_b_m), tone};
    case 6: return {change_text(m.change_m), m.change == ChangeClass::shrank ? Tone::warning : tone};
    case 7: return {m.growth_m_per_year ? fixed(*m.growth_m_per_year * 100.0, 2) : dash, tone};
    case 8: return {change_words(m.change), tone};
    case 9: return {fixed(m.confidence, 2), tone};
    default: return {to_string(m.state), tone};
  }
}

/// What a column sorts by; missing values go last.
double number_of(const MatchRow& m, std::size_t column) {
  constexpr double last = std::numeric_limits<double>::infinity();
  switch (column) {
    case 0: return static_cast<double>(m.tree.value);
    case 1: return static_cast<double>(m.a.inventory.value) * 1e9 + static_cast<double>(m.a.index);
    case 2: return static_cast<double>(m.b.inventory.value) * 1e9 + static_cast<double>(m.b.index);
    case 3: return m.distance_m;
    case 4: return m.dbh_a_m.value_or(last);
    case 5: return m.dbh_b_m.value_or(last);
    case 6: return m.change_m.value_or(last);
    case 7: return m.growth_m_per_year.value_or(last);
    case 8: return static_cast<double>(m.change);
    case 9: return m.confidence;
    default: return static_cast<double>(m.state);
  }
}

bool shows(const Frame& frame, const MatchRow& m, const std::string& text) {
  if (text.empty()) return true;
  const ProjectState& state = frame.state();
  const std::string all = tree_label(m.tree) + " " + stem_label(state, m.a) + " " + stem_label(state, m.b) + " " + to_string(m.state) + " " + change_words(m.change);
  return all.find(text) != std::string::npos;
}

}  // namespace

void MatchTable::arrange(const Frame& frame) {
  wanted_.revision = frame.derived.revision;
  wanted_.fate = frame.view.only_fate;
  if (wanted_ == key_) return;
  key_ = wanted_;
  rows_.clear();
  const std::vector<MatchRow>& all = frame.tables().matches;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const TreeRow* tree = key_.fate ? frame.derived.tree(all[i].tree) : nullptr;
    if (key_.fate && (tree == nullptr || tree->fate != *key_.fate)) continue;
    if (shows(frame, all[i], key_.text)) rows_.push_back(i);
  }
  std::stable_sort(rows_.begin(), rows_.end(), [&](std::size_t a, std::size_t b) {
    const double va = number_of(all[a], key_.column), vb = number_of(all[b], key_.column);
    return key_.ascending ? va < vb : va > vb;
  });
}

void MatchTable::draw(Widgets& w, Frame& frame) {
  arrange(frame);
  const std::vector<MatchRow>& all = frame.tables().matches;
  if (!all.empty()) {
    const std::string shown = count_text(static_cast<std::int64_t>(rows_.size())) + " of " + plural(static_cast<std::int64_t>(all.size()), "match", "matches");
    draw_filter(w, "matches/filter", wanted_.text, "Filter by tree, stem, state or change", shown);
  }
  TableView table;
  table.path = "matches";
  const std::vector<std::size_t> shown = columns_that_fit(w);
  for (const std::size_t column : shown) table.columns.push_back(columns()[column]);
  table.least_width = w.px(610);
  table.rows = rows_.size();
  table.cell = [&](std::size_t row, std::size_t column) { return cell_of(frame.state(), all[rows_[row]], shown[column]); };
  table.selected = [&](std::size_t row) { return all[rows_[row]].tree == frame.view.selected_tree; };
  table.clicked = [&](std::size_t row) {
    frame.requests.emit(request::SelectTree{all[rows_[row]].tree, true, all[rows_[row]].b});
  };
  table.sorted = [&](std::size_t column, bool ascending) {
    wanted_.column = shown[column];
    wanted_.ascending = ascending;
  };
  table.empty_text = all.empty() ? "Matches appear here when surveys are aligned." : "No match fits the filter.";
  if (shown_tree_ != frame.view.selected_tree) {
    shown_tree_ = frame.view.selected_tree;
    const auto it = std::find_if(rows_.begin(), rows_.end(), [&](std::size_t i) { return all[i].tree == shown_tree_; });
    if (it != rows_.end()) table.scroll_to = static_cast<std::size_t>(it - rows_.begin());
  }
  draw_table(w, table);
}

}  // namespace stemwise::ui
