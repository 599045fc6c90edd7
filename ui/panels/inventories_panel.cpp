#include "ui/panels/inventories_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels/alignment_words.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::string status_line(const ProjectState& state, const Inventory& inventory) {
  if (inventory.id == state.reference) return "reference";
  const auto it = state.alignments.find(inventory.id);
  if (it == state.alignments.end()) return "not aligned yet";
  const InventoryAlignment& a = it->second;
  switch (a.status) {
    case AlignmentStatus::aligned: return "overlap " + percent_text(a.overlap) + " · residual " + residual_text(a.residual_rms_m);
    case AlignmentStatus::probable: return "probable: waits for a decision";
    case AlignmentStatus::failed: return "refused";
    case AlignmentStatus::reference: return "reference";
    case AlignmentStatus::unaligned: break;
  }
  return "not aligned yet";
}

Tone status_tone(const ProjectState& state, const Inventory& inventory) {
  const auto it = state.alignments.find(inventory.id);
  if (inventory.id == state.reference || it == state.alignments.end()) return Tone::secondary;
  if (it->second.status == AlignmentStatus::aligned) return Tone::accent;
  return it->second.status == AlignmentStatus::unaligned ? Tone::secondary : Tone::warning;
}

}  // namespace

void draw_fate_mark(Widgets& w, Fate fate, float x, float y, float r) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Color c = fate_color(fate);
  const float line = w.px(1.4f);
  if (fate == Fate::outside_coverage) {
    draw->AddCircle({x, y}, r - 1, c.packed(), 24, line);
    return;
  }
  if (fate == Fate::unresolved) {  // the map's shapes: a diamond, and for what was removed a square
    const float reach = r * 1.15f;
    draw->AddQuadFilled({x, y - reach}, {x + reach, y}, {x, y + reach}, {x - reach, y}, c.packed());
  } else if (fate == Fate::removed) {
    draw->AddRectFilled({x - 0.9f * r, y - 0.9f * r}, {x + 0.9f * r, y + 0.9f * r}, c.packed());
  } else {
    draw->AddCircleFilled({x, y}, r, c.packed(), 24);
  }
  const float d = r * 0.55f;
  const auto ink = w.tokens().panel.packed();
  if (fate == Fate::missing || fate == Fate::dead || fate == Fate::removed) {
    draw->AddLine({x - d, y - d}, {x + d, y + d}, ink, line);
    draw->AddLine({x - d, y + d}, {x + d, y - d}, ink, line);
  } else if (fate == Fate::ingrowth) {
    draw->AddLine({x - d, y}, {x + d, y}, ink, line);
    draw->AddLine({x, y - d}, {x, y + d}, ink, line);
  } else if (fate == Fate::missed_earlier) {
    draw->AddCircleFilled({x, y}, d, ink, 16);
  }
}

void InventoriesPanel::draw(Widgets& w, Frame& frame) {
  draw_head(w, frame);
  // The reference on top, the others in the order of adding.
  const ProjectState& state = frame.state();
  if (const Inventory* reference = state.find(state.reference)) draw_card(w, frame, *reference);
  for (const auto& inventory : state.inventories) {
    if (inventory->id != state.reference) draw_card(w, frame, *inventory);
  }
  draw_fates(w, frame);
  draw_view_choices(w, frame);
  draw_alignment(w, frame);
}

void InventoriesPanel::draw_head(Widgets& w, Frame& frame) {
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in(row, "Inventories", TextRole::head, Tone::text);
  const float width = w.text_width("+ Add", TextRole::strong) + w.px(8);  // its word ends where the cards do
  w.button_in({row.right() + w.px(4) - width, row.y + w.px(2), width, w.px(24)}, "inventories/add", "+ Add",
              {.quiet = true, .why_not = frame.available[static_cast<std::size_t>(ActionId::file_add)].why_not, .tooltip = "Adds stem lists or frame folders  (Ctrl+I)"})
      ? frame.requests.run(ActionId::file_add)
      : void();
}

void InventoriesPanel::draw_card(Widgets& w, Frame& frame, const Inventory& inventory) {
  const Rect card = w.next_rect(w.available_width(), w.px(72));
  const bool selected = frame.view.selected_inventory == inventory.id;
  const Tokens& t = w.tokens();
  w.fill(card, selected ? t.accent_soft : t.panel, w.px(6));
  const std::string path = "inventories/" + inventory.name;
  draw_eye(w, frame, inventory, card);
  if (w.area(path, card, status_line(frame.state(), inventory))) frame.view.selected_inventory = inventory.id;
  w.outline(card, selected ? t.accent : t.line, w.px(6));
  ImGui::GetWindowDrawList()->AddRectFilled({card.x, card.y}, {card.x + w.px(4), card.bottom()}, inventory_color(frame.state(), inventory.id).packed(),
                                            w.px(4), ImDrawFlags_RoundCornersLeft);
  const float x = card.x + w.px(16);
  const float width = card.width - w.px(52);
  const float name_width = std::min(w.text_width(inventory.name, TextRole::head) + 1, width * 0.62f);
  w.text_in({x, card.y + w.px(7), name_width, w.px(20)}, w.middle_shortened(inventory.name, TextRole::head, name_width), TextRole::head, Tone::text);
  if (inventory.date) {
    w.text_in({x + name_width + w.px(8), card.y + w.px(8), width - name_width - w.px(8), w.px(20)}, date_text(*inventory.date), TextRole::table,
              Tone::secondary);
  }
  w.text_in({x, card.y + w.px(28), width, w.px(18)}, plural(static_cast<std::int64_t>(inventory.stems.size()), "stem", "stems"), TextRole::table, Tone::text);
  w.text_in({x, card.y + w.px(47), width + w.px(24), w.px(17)}, status_line(frame.state(), inventory), TextRole::table, status_tone(frame.state(), inventory));
}

void InventoriesPanel::draw_eye(Widgets& w, Frame& frame, const Inventory& inventory, const Rect& card) {
  const bool hidden = frame.view.hidden.contains(inventory.id);
  const Rect eye{card.right() - w.px(34), card.y + w.px(4), w.px(28), w.px(26)};
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  if (w.area("inventories/" + inventory.name + "/eye", eye, hidden ? "hidden" : "shown")) {
    hidden ? static_cast<void>(frame.view.hidden.erase(inventory.id)) : static_cast<void>(frame.view.hidden.insert(inventory.id));
  }
  if (ImGui::IsItemHovered()) w.tooltip(hidden ? "Show this survey" : "Hide this survey");
  w.text_in(eye, hidden ? icon::eye_off : icon::eye, TextRole::body, hidden ? Tone::faint : Tone::secondary, Align::center);
  ImGui::SetCursorScreenPos(cursor);
}

void InventoriesPanel::draw_fates(Widgets& w, Frame& frame) {
  const Tables& tables = frame.tables();
  if (tables.inventories.size() < 2) return;
  const ProjectState& state = frame.state();
  const std::string from = survey_label(state, tables.inventories[tables.inventories.size() - 2]);
  const std::string to = survey_label(state, tables.inventories.back());
  w.gap(8);
  w.paragraph("Fate of stems, " + from + " to " + to, TextRole::strong);
  w.record_last("fates/head", from + " to " + to);
  if (ImGui::IsItemHovered()) w.tooltip("What became of each tree between the last two surveys, " + from + " and " + to + ". Trees that neither of them saw are counted apart.");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < fate_count; ++i) {
    const auto fate = static_cast<Fate>(i);
    const int count = frame.derived.last_step_fates[i];
    if (count > 0 || (fate != Fate::dead && fate != Fate::removed)) draw_fate(w, frame, fate, count);
  }
  ImGui::Indent(w.px(24));
  if (frame.derived.dead_before > 0) {
    w.fact("fates/dead_before", "Dead by " + from, count_text(frame.derived.dead_before), "Recorded as dead in " + from + " or before: nothing became of them since.");
  }
  if (frame.derived.seen_before_only > 0) {
    w.fact("fates/seen_before", "Last seen before " + from, count_text(frame.derived.seen_before_only), "Seen in neither " + from + " nor " + to + ".");
  }
  ImGui::Unindent(w.px(24));
  ImGui::PopStyleVar();
}

void InventoriesPanel::draw_fate(Widgets& w, Frame& frame, Fate fate, int count) {
  const Rect row = w.next_rect(w.available_width(), w.px(24));
  const bool only = frame.view.only_fate == fate;
  if (only) w.fill({row.x - w.px(6), row.y, row.width + w.px(12), row.height}, w.tokens().accent_soft, w.px(6));
  if (w.area(std::string("fates/") + to_string(fate), {row.x - w.px(6), row.y, row.width + w.px(12), row.height}, std::to_string(count))) {
    frame.view.only_fate = only ? std::optional<Fate>{} : fate;
  }
  if (ImGui::IsItemHovered()) w.tooltip(only ? "Show trees of every fate in the tables again" : "Show only these in the tables");
  draw_fate_mark(w, fate, row.x + w.px(8), row.center_y(), w.px(6));
  w.text_in({row.x + w.px(24), row.y, row.width - w.px(84), row.height}, fate_label(fate), TextRole::body, Tone::text);
  w.text_in({row.right() - w.px(60), row.y, w.px(60), row.height}, count_text(count), TextRole::table, Tone::secondary, Align::right);
}

void InventoriesPanel::draw_view_choices(Widgets& w, Frame& frame) {
  if (frame.tables().inventories.size() < 2 && frame.state().inventories.size() > 1) return;  // each in its own colour until they are aligned
  w.gap(10);
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, w.px(64), row.height}, "Colour by", TextRole::table, Tone::secondary);
  static const std::vector<std::string> names{"Inventory", "Fate", "DBH", "DBH change", "Residual", "Confidence", "Times seen"};
  int current = static_cast<int>(frame.view.color_by);
  ImGui::SetCursorScreenPos({row.x + w.px(70), row.y});
  if (w.combo("view/color_by", names, current, row.width - w.px(70))) frame.view.color_by = static_cast<ColorBy>(current);
  draw_compare(w, frame);
}

void InventoriesPanel::draw_compare(Widgets& w, Frame& frame) {
  const std::vector<InventoryId>& placed = frame.tables().inventories;
  if (placed.size() < 2) return;
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, w.px(64), row.height}, "Compare", TextRole::table, Tone::secondary);
  const InventoryId first = placed[placed.size() - 2];
  const InventoryId last = placed.back();
  const bool first_hidden = frame.view.hidden.contains(first);
  const bool last_hidden = frame.view.hidden.contains(last);
  const int current = last_hidden && !first_hidden ? 0 : first_hidden && !last_hidden ? 2 : 1;
  const std::array<std::string, 3> names{survey_label(frame.state(), first), "Both", survey_label(frame.state(), last)};
  const float third = (row.width - w.px(70)) / 3.0f;
  const std::array<std::string, 3> labels{w.middle_shortened(names[0], TextRole::strong, third - w.px(11)), names[1], w.middle_shortened(names[2], TextRole::strong, third - w.px(11))};
  for (int i = 0; i < 3; ++i) {
    const Rect rect{row.x + w.px(70) + third * static_cast<float>(i), row.y, third - w.px(2), row.height};
    if (!w.button_in(rect, "view/compare/" + std::to_string(i), labels[static_cast<std::size_t>(i)],
                     {.active = i == current, .tooltip = i == 1 ? "Both surveys" : "Only " + names[static_cast<std::size_t>(i)]})) continue;
    frame.view.hidden.erase(first);
    frame.view.hidden.erase(last);
    if (i == 0) frame.view.hidden.insert(last);
    if (i == 2) frame.view.hidden.insert(first);
  }
}

void InventoriesPanel::draw_alignment(Widgets& w, Frame& frame) {
  const ProjectState& state = frame.state();
  InventoryId shown = frame.view.selected_inventory;
  if (shown == state.reference || !state.alignments.contains(shown)) {
    if (frame.tables().inventories.empty()) return;
    shown = frame.tables().inventories.back();
    if (shown == state.reference && frame.tables().inventories.size() > 1) shown = frame.tables().inventories.front();
  }
  const auto it = state.alignments.find(shown);
  if (shown == state.reference || it == state.alignments.end()) return;
  const InventoryAlignment& a = it->second;
  w.section("Alignment of " + survey_label(state, shown));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  if (a.status == AlignmentStatus::failed) {
    w.paragraph(sentence(a.reason), TextRole::table, Tone::warning);
  } else {
    w.fact("alignment/second_best", "Second-best pose", second_best_words(a.acceptance), "How well the next different pose fits. In a planted grid many poses fit.");
    w.fact("alignment/observed", "Observed", observed_words(a.observed), "Which of the six degrees of freedom the data decided; the others stay zero.");
    const auto shared = frame.derived.in_overlap.find(shown);
    const bool counted = shared != frame.derived.in_overlap.end() && shared->second.stems > 0;
    w.fact("alignment/overlap", "Matched in overlap", counted ? percent_text(static_cast<double>(shared->second.matched) / shared->second.stems, 1) : dash,
           counted ? count_text(shared->second.matched) + " of its " + count_text(shared->second.stems) + " stems that stand where another survey looked too were found there."
                   : "No other survey looked where this one did.");
    w.fact("alignment/noise", "Position noise", distance_text(a.position_noise_m), "One-axis standard deviation of the matched stems' positions.");
  }
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
