#include "ui/panels/inspector.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels/chart_view.hpp"
#include "ui/panels/inventories_panel.hpp"
#include "ui/text/confidence_words.hpp"
#include "ui/text/effect_words.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

constexpr double sure_from = 0.8;
constexpr double neighbours_within_m = 3.0;
constexpr std::size_t most_neighbours = 5;

std::array<Rect, 4> history_columns(const Rect& row) {
  const float widths[] = {0.235f, 0.24f, 0.245f, 0.28f};
  std::array<Rect, 4> cells;
  float x = row.x;
  for (std::size_t i = 0; i < 4; ++i) {
    cells[i] = {x, row.y, row.width * widths[i] - 4.0f, row.height};
    x += row.width * widths[i];
  }
  return cells;
}

std::string growth_sentence(const Frame& frame, const TreeRow& tree) {
  if (!tree.growth_from) return tree.times_seen < 2 ? "Seen in one survey only: no growth yet." : "No growth: its DBH was measured once only.";
  const std::string span = " from " + survey_label(frame.state(), tree.growth_from) + " to " + survey_label(frame.state(), tree.growth_to);
  const char* sense = tree.growth == ChangeClass::within_error ? ", within the error" : tree.growth == ChangeClass::shrank ? ", shrank more than the error" : "";
  if (!tree.growth_m_per_year) return "No growth rate" + span + ": a date is missing" + sense;
  return "Growth " + fixed(*tree.growth_m_per_year * 1000.0, 1) + " mm per year" + span + sense;
}

}  // namespace

void Inspector::draw(Widgets& w, Frame& frame) {
  const TreeRow* tree = frame.derived.tree(frame.view.selected_tree);
  if (!frame.view.group.empty()) {
    draw_group(w, frame);
    return;
  }
  if (tree == nullptr) {
    draw_nothing(w, frame);
    return;
  }
  draw_head(w, frame, *tree);
  draw_confidence(w, frame, *tree);
  draw_history(w, frame, *tree);
  w.section("DBH over time");
  const Rect chart = w.next_rect(w.available_width(), w.px(150));
  draw_chart(w, frame, Chart::tree_history, chart, "review/chart");
  w.paragraph(growth_sentence(frame, *tree), TextRole::table, Tone::secondary);
  draw_buttons(w, frame);
  draw_alternatives(w, frame, *tree);
  draw_note(w, frame, *tree);
}

void Inspector::draw_nothing(Widgets& w, Frame& frame) {
  w.text("No tree selected", TextRole::title);
  w.gap(4);
  w.paragraph("Click a stem on the map, a row in the tables, or press N for the most doubtful tree.", TextRole::body, Tone::secondary);
  w.gap(12);
  w.action_button("review/next", ActionId::review_next, frame.available, frame.requests, {.width = -1.0f});
}

void Inspector::draw_head(Widgets& w, Frame& frame, const TreeRow& tree) {
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  const std::string label = tree_label(tree.tree);
  const float label_width = w.text_width(label, TextRole::title);
  w.text_in({row.x, row.y, label_width + 1, row.height}, label, TextRole::title, Tone::text);
  w.record("review/tree", {row.x, row.y, label_width, row.height}, label);
  const std::string fate = fate_label(tree.fate);
  const float pill_width = w.text_width(fate, TextRole::strong) + w.px(28);
  const float left = row.x + label_width + w.px(16), room = row.right() - left - pill_width - w.px(8);
  const bool beside = w.text_width(tree.species, TextRole::table) <= room;
  if (beside) w.text_in({left, row.y, room, row.height}, tree.species, TextRole::table, Tone::secondary);
  w.pill("review/fate", fate, fate_color(tree.fate), row.right(), row.y + w.px(2));
  ImGui::Dummy({row.width, row.height});
  const auto it = frame.state().trees.find(tree.tree);
  const bool by_hand = it != frame.state().trees.end() && it->second.fate_by_hand;
  if (beside && !by_hand) return;
  const Rect line = w.next_rect(w.available_width(), w.px(18));  // a long species has a line of its own
  if (!beside) w.text_in({line.x, line.y, 0.6f * line.width, line.height}, tree.species, TextRole::table, Tone::secondary);
  if (by_hand) w.text_in(line, "fate set by hand", TextRole::caption, Tone::secondary, Align::right);
  ImGui::Dummy({line.width, line.height});
}

void Inspector::draw_confidence(Widgets& w, Frame& frame, const TreeRow& tree) {
  const QueueRow* doubt = frame.derived.doubt(tree.tree);
  const MatchRow* match = match_to_decide(frame.derived, frame.view);
  const bool decided = doubt == nullptr || doubt->decided;
  const MatchRow* doubted = doubt != nullptr && doubt->match ? &frame.tables().matches[*doubt->match] : nullptr;
  if (match != nullptr) {
    const std::string state = match->state == MatchState::automatic ? "" : std::string(" · ") + to_string(match->state) + " by hand";
    const bool sure = match->confidence >= sure_from || match->state != MatchState::automatic;
    const std::string confidence = "Confidence " + fixed(match->confidence, 2) + state;
    const std::string pair = stem_label(frame.state(), match->a) + " and " + stem_label(frame.state(), match->b);
    const float room = w.available_width() - w.text_width(confidence, TextRole::strong) - w.px(16);
    const Rect line = w.next_rect(w.available_width(), w.line_height(TextRole::strong));
    w.text(confidence, TextRole::strong, sure ? Tone::accent : Tone::warning);
    w.record_last("review/confidence", confidence_words(*match));
    if (ImGui::IsItemHovered()) w.tooltip("How sure it is that these two stems are one tree, by their distance, their diameters and what else would fit. 1 is certain.");
    const bool beside = w.text_width(pair, TextRole::table) <= room;
    if (beside) {
      w.text_in(line, pair, TextRole::table, Tone::secondary, Align::right);
      w.record("review/pair", line, pair);
    }
    if (state.empty() || match->state == MatchState::rejected) w.paragraph(confidence_words(*match), TextRole::table, Tone::secondary);
    if (!beside) {
      w.paragraph(pair, TextRole::table, Tone::secondary);
      w.record_last("review/pair", pair);
    }
  }
  std::string why = match != nullptr ? "" : "seen in one survey only";
  if (doubt != nullptr) why = doubt->why;
  if (!decided && doubted != nullptr && doubted != match) {
    why = "in doubt is " + stem_label(frame.state(), doubted->a) + " and " + stem_label(frame.state(), doubted->b) + ": " + why;
  }
  for (const std::string& flag : tree.flags) why += (why.empty() ? "" : "; ") + flag_words(flag);
  if (why.empty()) return;
  w.paragraph(why, TextRole::table, decided ? Tone::secondary : Tone::warning);
  w.record_last("review/why", why);
}

void Inspector::draw_history(Widgets& w, Frame& frame, const TreeRow& tree) {
  w.gap(6);
  const Rect head = w.next_rect(w.available_width(), w.px(24));
  const char* names[] = {"Survey", "DBH, cm", "Residual", "Source row"};
  const std::array<Rect, 4> cells = history_columns(head);
  for (std::size_t i = 0; i < 4; ++i) w.text_in(cells[i], names[i], TextRole::caption, Tone::secondary);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::Dummy({head.width, head.height});
  for (const ObservationRow* row : frame.derived.sightings(tree.tree)) draw_sighting(w, frame, *row);
  ImGui::PopStyleVar();
}

void Inspector::draw_sighting(Widgets& w, Frame& frame, const ObservationRow& row) {
  const Rect rect = w.next_rect(w.available_width(), w.px(24));
  w.hairline(rect.x, rect.y, rect.right(), rect.y + 1);
  const std::string label = stem_label(frame.state(), row.stem);
  const bool target = unlink_target(frame.state(), frame.view) == row.stem;
  const MatchRow* match = match_to_decide(frame.derived, frame.view);
  const bool in_pair = match != nullptr && (match->a == row.stem || match->b == row.stem);
  const Rect mark{rect.x - w.px(6), rect.y + 1, rect.width + w.px(12), rect.height - 1};
  if (target) w.fill(mark, w.tokens().accent_soft, w.px(4));
  if (in_pair) w.fill({mark.x, mark.y, w.px(3), mark.height}, w.tokens().accent);
  if (w.area("review/history/" + label, rect, target ? "taken out by Unlink" : in_pair ? "of the pair" : "")) frame.view.selected_stem = row.stem;
  const char* pair = in_pair ? "Accept and Reject decide on the two marked stems. " : "";
  if (ImGui::IsItemHovered()) w.tooltip(label + ". " + pair + (target ? "Unlink takes this stem out of the tree." : "Click: decide on this stem instead."));
  const std::array<Rect, 4> cells = history_columns(rect);
  w.text_in(cells[0], survey_label(frame.state(), row.stem.inventory), TextRole::table, Tone::text);
  const std::string error = row.dbh_m && row.dbh_error_m ? " ± " + fixed(*row.dbh_error_m * 100.0, 1) : "";
  w.text_in(cells[1], dbh_text(row.dbh_m) + error, TextRole::table, Tone::text);
  w.text_in(cells[2], row.residual_m ? residual_text(*row.residual_m) : dash, TextRole::table, Tone::text);
  w.text_in(cells[3], w.middle_shortened(label, TextRole::table, cells[3].width), TextRole::table, Tone::text);
}

void Inspector::draw_buttons(Widgets& w, Frame& frame) {
  w.gap(10);
  const Rect block = w.next_rect(w.available_width(), w.px(144));
  const float gap = w.px(8);
  const float half = 0.5f * (block.width - gap);
  const float height = w.px(30);
  const auto place = [&](int column, int row) { return Rect{block.x + static_cast<float>(column) * (half + gap), block.y + static_cast<float>(row) * (height + gap), half, height}; };
  const auto button = [&](int column, int row, const char* path, ActionId id, ButtonLook look) { w.action_button_in(place(column, row), path, id, frame.available, frame.requests, std::move(look)); };
  button(0, 0, "review/accept", ActionId::review_accept, {.primary = true, .tooltip = accept_words(frame)});
  button(1, 0, "review/reject", ActionId::review_reject, {.tooltip = reject_words(frame)});
  button(0, 1, "review/link", ActionId::review_link, {.active = frame.view.tool == Tool::link});
  button(1, 1, "review/unlink", ActionId::review_unlink, {.tooltip = unlink_words(frame)});
  button(0, 2, "review/swap", ActionId::review_swap, {.active = frame.view.tool == Tool::swap});
  button(1, 2, "review/split", ActionId::review_split, {.tooltip = split_words(frame)});
  button(0, 3, "review/merge", ActionId::review_merge, {.active = frame.view.tool == Tool::merge});
  button(1, 3, "review/next", ActionId::review_next, {});
  ImGui::SetCursorScreenPos({block.x, block.bottom()});
  ImGui::Dummy({block.width, w.px(4)});
}

void Inspector::draw_group(Widgets& w, Frame& frame) {
  const std::vector<TreeId>& group = frame.view.group;
  const std::string title = plural(static_cast<std::int64_t>(group.size()), "tree", "trees") + " selected";
  w.text(title, TextRole::title);
  w.record_last("group/count", title);
  w.paragraph("Decisions mean all of them, and one Undo takes them back. Esc: select none.", TextRole::table, Tone::secondary);
  std::array<int, fate_count> fates{};
  int open = 0, doubtful = 0;
  for (const TreeId id : group) {
    const TreeRow* tree = frame.derived.tree(id);
    if (tree != nullptr) ++fates[static_cast<std::size_t>(tree->fate)];
    for (const MatchRow* match : frame.derived.matches_of(id)) open += match->state == MatchState::automatic ? 1 : 0;
    const QueueRow* doubt = frame.derived.doubt(id);
    doubtful += doubt != nullptr && !doubt->decided ? 1 : 0;
  }
  w.gap(8);
  for (std::size_t i = 0; i < fate_count; ++i) {
    if (fates[i] == 0) continue;
    const auto fate = static_cast<Fate>(i);
    const Rect row = w.next_rect(w.available_width(), w.px(24));
    draw_fate_mark(w, fate, row.x + w.px(8), row.center_y(), w.px(6));
    ImGui::Indent(w.px(24));
    w.fact(std::string("group/fate/") + to_string(fate), fate_label(fate), count_text(fates[i]));
    ImGui::Unindent(w.px(24));
  }
  w.fact("group/open", "Matches not decided by hand", count_text(open));
  w.fact("group/doubtful", "Trees in doubt", count_text(doubtful));
  w.gap(10);
  const auto button = [&](const char* path, ActionId id, ButtonLook look) {
    look.width = -1.0f;
    w.action_button(path, id, frame.available, frame.requests, std::move(look));
  };
  button("group/accept", ActionId::review_accept, {.primary = true, .tooltip = "Accepts " + plural(open, "match", "matches") + " and the fates that are in doubt"});
  button("group/reject", ActionId::review_reject, {.tooltip = "Rejects the matches that are in doubt; the others stay"});
  w.section("Fate of all of them");
  for (const ActionId id : {ActionId::review_dead, ActionId::review_removed, ActionId::review_missed_earlier, ActionId::review_ingrowth, ActionId::review_clear_fate}) {
    button((std::string("group/") + action(id).name).c_str(), id, {});
  }
}

void Inspector::find_neighbours(const Frame& frame, const TreeRow& tree) {
  if (neighbours_at_ == frame.derived.revision && neighbours_of_ == tree.tree) return;
  neighbours_at_ = frame.derived.revision;
  neighbours_of_ = tree.tree;
  neighbours_.clear();
  const std::vector<const ObservationRow*> own = frame.derived.sightings(tree.tree);
  if (own.empty()) return;
  for (const ObservationRow& row : frame.tables().observations) {
    const auto same_survey = [&](const ObservationRow* o) { return o->stem.inventory == row.stem.inventory; };
    if (row.tree == tree.tree || std::any_of(own.begin(), own.end(), same_survey)) continue;
    const double distance_m = (row.position_m - own.back()->position_m).head<2>().norm();
    if (distance_m > neighbours_within_m) continue;
    const auto match = frame.state().matches.find(ordered(own.back()->stem, row.stem));
    neighbours_.push_back({own.back()->stem, row.stem, distance_m, match != frame.state().matches.end() && !match->second.joins()});
  }
  std::sort(neighbours_.begin(), neighbours_.end(), [](const Neighbour& a, const Neighbour& b) { return a.distance_m < b.distance_m; });
  if (neighbours_.size() > most_neighbours) neighbours_.resize(most_neighbours);
}

void Inspector::draw_alternative(Widgets& w, Frame& frame, const Neighbour& stem, bool current) {
  const Rect row = w.next_rect(w.available_width(), w.px(24));
  const Stem* found = frame.state().find(stem.to);
  const std::string label = stem_label(frame.state(), stem.to);
  if (w.area("review/alternative/" + label, row, distance_text(stem.distance_m)) && !current) frame.requests.emit(request::LinkStems{stem.from, stem.to});
  const std::string hint = stem.rejected ? "Rejected by hand. Click: link it after all" : "Click: link " + stem_label(frame.state(), stem.from) + " to this stem";
  if (ImGui::IsItemHovered()) w.tooltip(current ? "The stem it is matched with" : hint);
  const Tone tone = current ? Tone::accent : stem.rejected ? Tone::secondary : Tone::text;
  w.text_in({row.x, row.y, row.width * 0.46f, row.height}, w.middle_shortened(label, TextRole::table, row.width * (stem.rejected ? 0.26f : 0.46f)) + (stem.rejected ? " (rejected)" : ""), TextRole::table, tone);
  w.text_in({row.x + row.width * 0.48f, row.y, w.px(70), row.height}, distance_text(stem.distance_m), TextRole::table, Tone::text);
  w.text_in({row.right() - w.px(80), row.y, w.px(80), row.height}, found != nullptr && found->dbh_m ? dbh_text(found->dbh_m) + " cm" : dash, TextRole::table, Tone::text,
            Align::right);
}

void Inspector::draw_alternatives(Widgets& w, Frame& frame, const TreeRow& tree) {
  w.section("Alternatives");
  find_neighbours(frame, tree);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  std::vector<StemRef> shown;
  const auto line = [&](const Neighbour& stem, bool current) {
    if (std::find(shown.begin(), shown.end(), stem.to) != shown.end()) return;
    shown.push_back(stem.to);
    draw_alternative(w, frame, stem, current);
  };
  for (const MatchRow* row : frame.derived.matches_of(tree.tree)) {
    if (row->state == MatchState::rejected) continue;
    line({row->a, row->b, row->distance_m, false}, true);
    const auto it = frame.state().matches.find(ordered(row->a, row->b));
    if (it == frame.state().matches.end() || !it->second.second_choice) continue;
    const StemRef other = *it->second.second_choice;
    line({other.inventory == row->a.inventory ? row->b : row->a, other, it->second.second_distance_m.value_or(0.0), false}, false);
  }
  for (const Neighbour& stem : neighbours_) line(stem, false);
  ImGui::PopStyleVar();
  if (shown.empty()) w.text("No stem of another survey within " + fixed(neighbours_within_m, 0) + " m", TextRole::table, Tone::secondary);
}

void Inspector::draw_note(Widgets& w, Frame& frame, const TreeRow& tree) {
  w.gap(10);
  if (noted_ != tree.tree) {
    if (is_note_typed_ && frame.state().trees.contains(noted_)) frame.requests.emit(request::SetNote{noted_, note_});  // left without the field's knowing
    is_note_typed_ = false;
    noted_ = tree.tree;
    note_ = tree.note;
  }
  if (w.input("review/note", note_, {.hint = "Add a note for the edit log", .lines = 3})) is_note_typed_ = note_ != tree.note;
  if (!ImGui::IsItemDeactivatedAfterEdit()) return;
  if (note_ != tree.note) frame.requests.emit(request::SetNote{tree.tree, note_});
  is_note_typed_ = false;
}

}  // namespace stemwise::ui
