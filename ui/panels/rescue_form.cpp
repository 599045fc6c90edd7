#include "ui/panels/rescue_form.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/text/format.hpp"

namespace stemwise::ui {

void RescueForm::draw(Widgets& w, Frame& frame, const Inventory& inventory) {
  draw_pairs(w, frame, inventory);
  draw_position(w, frame, inventory);
}

void RescueForm::draw_pairs(Widgets& w, Frame& frame, const Inventory& inventory) {
  w.section("These two are the same tree");
  w.paragraph("Click a tree of " + survey_label(frame.state(), frame.state().reference) + " and the same tree of " + inventory.name + ", which stands beside it on the map. Two pairs are enough.",
              TextRole::table, Tone::secondary);
  const bool picking = frame.view.tool == Tool::pair;
  if (w.button("align/rescue/pick", picking ? "Stop picking" : "Pick pairs on the map", {.active = picking, .width = -1.0f})) {
    frame.view.tool = picking ? Tool::select : Tool::pair;
    frame.view.link_from = {};
    frame.view.mode = ViewMode::map;
    frame.view.slide = frame.view.before_after = frame.view.blink = false;
    frame.view.selected_inventory = inventory.id;
  }
  int count = 0;
  std::size_t gone = frame.view.pairs.size();
  for (std::size_t i = 0; i < frame.view.pairs.size(); ++i) {
    const auto& [known, other] = frame.view.pairs[i];
    if (other.inventory != inventory.id) continue;
    ++count;
    const std::string words = stem_label(frame.state(), known) + " and " + stem_label(frame.state(), other);
    const Rect row = w.next_rect(w.available_width(), w.px(26));
    w.text_in({row.x, row.y, row.width - w.px(30), row.height}, words, TextRole::table, Tone::text);
    w.record("align/rescue/pair/" + std::to_string(count), row, words);
    if (w.button_in({row.right() - w.px(24), row.y + w.px(1), w.px(24), w.px(24)}, "align/rescue/drop/" + std::to_string(count), "", {.quiet = true, .icon = icon::cross, .tooltip = "Not this pair"})) gone = i;
  }
  if (gone < frame.view.pairs.size()) frame.view.pairs.erase(frame.view.pairs.begin() + static_cast<std::ptrdiff_t>(gone));
  const std::string& no_run = frame.available[static_cast<std::size_t>(ActionId::align_run)].why_not;
  const std::string why_not = !no_run.empty() ? no_run : count < 2 ? "Two pairs are needed, as far apart as possible" : "";
  if (w.button("align/rescue/by_pairs", "Align with these pairs", {.primary = count >= 2, .width = -1.0f, .why_not = why_not})) frame.requests.emit(request::AlignByPairs{});
}

void RescueForm::draw_position(Widgets& w, Frame& frame, const Inventory& inventory) {
  w.gap(4);
  if (!w.fold("align/rescue/position", "Or a rough position", position_open_)) return;
  w.paragraph("Where does the origin of " + inventory.name + " roughly lie in the reference, and how is it turned?", TextRole::table, Tone::secondary);
  struct Item { const char* path; const char* name; double& value; const char* format; };
  const Item items[] = {{"align/rescue/x", "x, m", x_m_, "%.1f"}, {"align/rescue/y", "y, m", y_m_, "%.1f"},
                        {"align/rescue/yaw", "Turned counter-clockwise, °", yaw_deg_, "%.1f"}, {"align/rescue/radius", "Known to within, m", radius_m_, "%.1f"}};
  for (const Item& item : items) {
    const Rect row = w.next_rect(w.available_width(), w.px(28));
    w.text_in({row.x, row.y, row.width * 0.6f, row.height}, item.name, TextRole::table, Tone::secondary);
    ImGui::SetCursorScreenPos({row.x + row.width * 0.62f, row.y});
    w.number(item.path, item.value, item.format);
  }
  const std::string& no_run = frame.available[static_cast<std::size_t>(ActionId::align_run)].why_not;
  if (w.button("align/rescue/run", "Align with this position", {.width = -1.0f, .why_not = no_run})) {
    frame.requests.emit(request::RoughPose{inventory.id, x_m_, y_m_, yaw_deg_, std::max(radius_m_, 0.5)});
  }
}

}  // namespace stemwise::ui
