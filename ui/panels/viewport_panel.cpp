#include "ui/panels/viewport_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/alignment_words.hpp"
#include "ui/panels/underlay_list.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {

namespace {

std::string pair_words(const Frame& frame) {
  const auto pairs = static_cast<std::int64_t>(frame.view.pairs.size());
  const std::string done = pairs == 0 ? "" : plural(pairs, "pair", "pairs") + (pairs >= 2 ? ", enough: press Align with these pairs. " : ", one more is needed. ");
  if (frame.view.link_from.index < 0) return done + "Click a tree of the reference, then the same one of the other survey.  Esc: stop";
  return done + "Click the stem that is the same tree as " + stem_label(frame.state(), frame.view.link_from) + ".  Esc: stop";
}

std::string ghost_words(const Frame& frame) {
  const auto it = frame.state().alignments.find(survey_to_compare(frame.state(), frame.view));
  if (it == frame.state().alignments.end()) return "";
  if (it->second.status == AlignmentStatus::probable) return "the proposed pose";
  const std::string words = second_best_words(it->second.acceptance);
  return "its second-best pose, " + (words.starts_with("no ") ? "which does not fit" : words);
}

/// What the tool in hand waits for; "" when there is nothing to say.
std::string banner_words(const Frame& frame) {
  std::string text;
  const std::string from = stem_label(frame.state(), frame.view.link_from);
  if (frame.view.tool == Tool::swap) text = "Click the stem that " + from + " changes places with.  Esc: never mind";
  if (frame.view.tool == Tool::merge) text = "Click the tree that is the same as that of " + from + ".  Esc: never mind";
  if (frame.view.tool == Tool::rectangle) text = "Drag a rectangle around trees; Ctrl adds to those selected.  Esc: stop";
  if (frame.view.tool == Tool::link) text = "Click the stem that is the same tree as " + from + ".  Esc: never mind";
  if (frame.view.tool == Tool::measure) text = frame.status.measure_text;
  if (frame.view.tool == Tool::lasso) text = "Click corners around trees; Enter or the first corner ends it, Backspace takes one back.  Esc: stop";
  if (frame.view.tool == Tool::coverage) text = "Click the corners of the ground that " + survey_label(frame.state(), frame.view.selected_inventory) + " covers; Enter ends it.  Esc: stop";
  if (frame.view.tool == Tool::pair) text = pair_words(frame);
  if (text.empty() && frame.view.ghost && frame.can(ActionId::view_ghost)) text = "Hollow: " + survey_label(frame.state(), survey_to_compare(frame.state(), frame.view)) + " at " + ghost_words(frame) + ".  G: hide";
  if (frame.view.blink) text = "Blinking between surveys.  Space: stop";
  return text;
}

}  // namespace

void ViewportPanel::draw(Widgets& w, Frame& frame, const Rect& rect) {
  draw_picture(w, frame, rect);
  draw_over_picture(w, frame, rect);  // under the card of the tree
  draw_hover(w, frame, rect);
  draw_tools(w, frame, rect);
  draw_banner(w, frame, rect);
}

void ViewportPanel::draw_picture(Widgets& w, Frame& frame, const Rect& rect) {
  const ViewportPicture& picture = frame.status.viewport;
  if (picture.texture == 0) w.fill(rect, w.tokens().map);
  if (picture.texture != 0) {
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.texture)), {rect.x, rect.y},
                                         {rect.right(), rect.bottom()}, {0, 1}, {1, 0});
  }
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::InvisibleButton("viewport", {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
  ImGui::SetItemAllowOverlap();
  w.record_last("viewport", frame.view.mode == ViewMode::map ? "map" : "3D");
  send_pointer(frame, rect);
  if (picture.later_texture != 0) draw_later(w, frame, rect);
}

/// The later survey right of a bar that is dragged; the names stand beside its foot.
void ViewportPanel::draw_later(Widgets& w, Frame& frame, const Rect& rect) {
  const ViewportPicture& picture = frame.status.viewport;
  float& at = frame.view.slide_at;
  const float grip = w.px(18);
  const float x = rect.x + at * rect.width;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.later_texture)), {x, rect.y}, {rect.right(), rect.bottom()}, {at, 1}, {1, 0});
  const Rect handle{x - 0.5f * grip, rect.center_y() - w.px(20), grip, w.px(40)};
  ImGui::SetCursorScreenPos({handle.x, handle.y});
  ImGui::InvisibleButton("slide", {handle.width, handle.height});
  w.record_last("viewport/slide", picture.earlier + " | " + picture.later);
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (active) at = std::clamp(at + ImGui::GetIO().MouseDelta.x / std::max(rect.width, 1.0f), 0.02f, 0.98f);
  w.fill({x - 1, rect.y, w.px(2), rect.height}, w.tokens().accent);
  w.fill(handle, active ? w.tokens().accent : w.tokens().panel, 0.5f * grip);
  w.outline(handle, w.tokens().accent, 0.5f * grip);
  const float y = rect.bottom() - w.px(34), height = w.px(24);
  const auto name = [&](const std::string& text, bool left) {
    const float width = w.text_width(text, TextRole::strong) + w.px(20);
    const Rect plate{left ? x - width - w.px(8) : x + w.px(8), y, width, height};
    if (plate.x < rect.x || plate.right() > rect.right()) return;
    w.fill(plate, w.tokens().panel, w.px(6));
    w.outline(plate, w.tokens().line, w.px(6));
    w.text_in(plate, text, TextRole::strong, Tone::text, Align::center);
  };
  name(picture.earlier, true);
  name(picture.later, false);
}

void ViewportPanel::send_pointer(Frame& frame, const Rect& rect) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool active = ImGui::IsItemActive();
  request::Pointer p;
  p.hovered = ImGui::IsItemHovered();
  p.x_px = io.MousePos.x - rect.x;
  p.y_px = io.MousePos.y - rect.y;
  p.shift = io.KeyShift;
  p.ctrl = io.KeyCtrl;
  if (ImGui::IsItemActivated()) {
    press_x_ = io.MousePos.x;
    press_y_ = io.MousePos.y;
    moved_ = false;
  }
  moved_ = moved_ || (active && std::hypot(io.MousePos.x - press_x_, io.MousePos.y - press_y_) > 4.0f);
  if (active && moved_) {
    p.left_down = io.MouseDown[0];
    p.right_down = io.MouseDown[1];
    p.middle_down = io.MouseDown[2];
    p.dx_px = io.MouseDelta.x;
    p.dy_px = io.MouseDelta.y;
  }
  p.clicked = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(0) && !moved_;
  p.double_clicked = p.hovered && ImGui::IsMouseDoubleClicked(0);
  if (p.hovered) p.wheel = io.MouseWheel;
  frame.requests.emit(p);
}

void ViewportPanel::draw_tools(Widgets& w, Frame& frame, const Rect& rect) {
  const float height = w.px(30);
  float x = rect.x + w.px(12);
  const float y = rect.y + w.px(12);
  const Tokens& t = w.tokens();
  // In a narrow view everything is as wide as its word.
  const bool narrow = rect.width < w.px(540);
  const float half = narrow ? w.px(48) : w.px(74), gap = narrow ? w.px(4) : w.px(6);
  const auto width_of = [&](const char* label) { return narrow ? w.text_width(label, TextRole::strong) + w.px(26) : w.px(76); };
  const Rect modes{x, y, 2 * half + 2, height};
  w.fill(modes, t.panel, w.px(6));
  w.outline(modes, t.line, w.px(6));
  const bool map = frame.view.mode == ViewMode::map;
  if (w.button_in({x + 2, y + 2, half, height - 4}, "viewport/map", "Map", {.quiet = !map, .active = map, .tooltip = "The map from above  (M)"}) && !map) {
    frame.requests.run(ActionId::view_mode);
  }
  if (w.button_in({x + 2 + half, y + 2, half - 2, height - 4}, "viewport/3d", "3D", {.quiet = map, .active = !map, .tooltip = "Stems as cylinders  (M)"}) && map) {
    frame.requests.run(ActionId::view_mode);
  }
  x = modes.right() + (narrow ? w.px(8) : w.px(12));
  struct Item { const char* path; const char* label; ActionId id; bool on; };
  const Item items[] = {{"viewport/select", "Select", ActionId::tool_select, frame.view.tool == Tool::select},
                        {"viewport/measure", "Measure", ActionId::tool_measure, frame.view.tool == Tool::measure},
                        {"viewport/link", "Link", ActionId::review_link, frame.view.tool == Tool::link}};
  for (const Item& item : items) {
    const std::string& why_not = frame.available[static_cast<std::size_t>(item.id)].why_not;
    const std::string hint = std::string(action(item.id).help) + "  (" + to_string(action(item.id).chord) + ")";
    const float width = width_of(item.label);
    if (w.button_in({x, y, width, height}, item.path, item.label, {.active = item.on, .plate = true, .why_not = why_not, .tooltip = hint})) frame.requests.run(item.id);
    x += width + gap;
  }
  const Rect layers{x, y, width_of("Layers"), height};
  if (w.button_in(layers, "viewport/layers", "Layers", {.plate = true, .tooltip = "What is laid over the stems"})) ImGui::OpenPopup("layers");
  draw_layers(w, frame, layers);
}

void ViewportPanel::draw_layers(Widgets& w, Frame& frame, const Rect& button) {
  const float top = button.bottom() + w.px(4);
  ImGui::SetNextWindowPos({button.x, top});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y - top - w.px(8)});
  if (!ImGui::BeginPopup("layers")) return;
  Layers& l = frame.view.layers;
  w.checkbox("layers/links", "Match links", l.links);
  w.checkbox("layers/residuals", "Residual arrows", l.residuals);
  w.checkbox("layers/coverage", "Coverage of each survey", l.coverage);
  w.checkbox("layers/grid", "Grid", l.grid);
  w.checkbox("layers/ground", "Ground (3D)", l.ground);
  w.checkbox("layers/labels", "Tree labels", l.labels);
  int heat = static_cast<int>(frame.view.heat);
  w.gap(6);
  w.text("Heat map", TextRole::caption, Tone::secondary);
  if (w.combo("layers/heat", {"none", "stem density", "times seen", "mean residual"}, heat, w.px(200))) frame.view.heat = static_cast<Heat>(heat);
  draw_underlays(w, frame);
  ImGui::EndPopup();
}

void ViewportPanel::draw_hover(Widgets& w, Frame& frame, const Rect& rect) {
  if (!frame.status.hover) return;
  const HoverCard& card = *frame.status.hover;
  const float width = std::max(w.text_width(card.title, TextRole::strong), w.text_width(card.detail, TextRole::table)) + w.px(26);
  const float height = w.px(card.detail.empty() ? 32 : 52);
  float x = rect.x + static_cast<float>(card.x_px) + w.px(26);
  float y = rect.y + static_cast<float>(card.y_px) - 0.5f * height;
  const bool on_key = frame.view.heat != Heat::none && frame.view.mode == ViewMode::map && x + width > rect.right() - w.px(232) && y + height > rect.bottom() - w.px(152);
  if (on_key || x + width > rect.right() - w.px(8)) x = rect.x + static_cast<float>(card.x_px) - w.px(26) - width;
  if (x < rect.x + w.px(8)) {  // room on neither side: below the stem
    x = std::max(rect.x + w.px(8), std::min(rect.x + static_cast<float>(card.x_px) - 0.5f * width, rect.right() - w.px(8) - width));
    y = rect.y + static_cast<float>(card.y_px) + w.px(30);
  }
  y = std::clamp(y, rect.y + w.px(48), std::max(rect.y + w.px(48), rect.bottom() - height - w.px(8)));
  const Rect plate{std::round(x), std::round(y), width, height};
  w.fill(plate, w.tokens().panel, w.px(6));
  w.outline(plate, w.tokens().line, w.px(6));
  w.text_in({plate.x + w.px(12), plate.y + w.px(6), width, w.px(20)}, card.title, TextRole::strong, Tone::text);
  if (!card.detail.empty()) {
    w.text_in({plate.x + w.px(12), plate.y + w.px(27), width, w.px(18)}, card.detail, TextRole::table, card.warning ? Tone::warning : Tone::secondary);
  }
  w.record("viewport/hover", plate, card.title);
  w.record("viewport/tree", {rect.x + static_cast<float>(card.x_px), rect.y + static_cast<float>(card.y_px), 0, 0}, card.title);
}

/// The polygon that is being drawn, and pairs of stems said to be the same.
void ViewportPanel::draw_lines(Widgets& w, Frame& frame, const Rect& rect) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto at = [&](double x, double y) { return ImVec2{rect.x + static_cast<float>(x), rect.y + static_cast<float>(y)}; };
  const auto accent = w.tokens().accent.packed();
  for (std::size_t i = 0; i < frame.status.shape.size(); ++i) {
    const OverlayLine& line = frame.status.shape[i];
    const bool closes = i + 1 == frame.status.shape.size();  // not drawn yet: where it would close
    draw->AddLine(at(line.x0_px, line.y0_px), at(line.x1_px, line.y1_px), closes ? w.tokens().accent.with_alpha(0.4f).packed() : accent, w.px(1.6f));
    draw->AddCircleFilled(at(line.x0_px, line.y0_px), w.px(3.5f), accent);
  }
  for (const OverlayMark& mark : frame.status.control_marks) {
    const Tone tone = mark.warning ? Tone::warning : Tone::accent;
    const ImVec2 c = at(mark.x_px, mark.y_px);
    const float r = w.px(7);
    draw->AddCircle(c, r, w.color(tone).packed(), 24, w.px(2));
    draw->AddLine({c.x - 1.7f * r, c.y}, {c.x + 1.7f * r, c.y}, w.color(tone).packed(), w.px(1.4f));
    draw->AddLine({c.x, c.y - 1.7f * r}, {c.x, c.y + 1.7f * r}, w.color(tone).packed(), w.px(1.4f));
    const float width = w.text_width(mark.words, TextRole::caption) + w.px(10);
    const Rect plate{c.x + w.px(12), c.y - w.px(24), width, w.px(18)};
    w.fill(plate, w.tokens().panel.with_alpha(0.9f), w.px(4));
    w.text_in(plate, mark.words, TextRole::caption, tone, Align::center);
  }
  for (const OverlayLine& line : frame.status.pair_lines) {
    draw->AddLine(at(line.x0_px, line.y0_px), at(line.x1_px, line.y1_px), w.tokens().warning.packed(), w.px(2));
    draw->AddCircleFilled(at(line.x0_px, line.y0_px), w.px(4), w.tokens().warning.packed());
  }
}

/// Enter ends the polygon, Backspace takes its last corner back.
void ViewportPanel::run_shape_keys(Frame& frame) {
  if (frame.view.tool != Tool::lasso && frame.view.tool != Tool::coverage) return;
  if (frame.view.dialog != Dialog::none || ImGui::GetIO().WantTextInput) return;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) frame.requests.emit(request::Shape{true});
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Backspace), false)) frame.requests.emit(request::Shape{false});
}

void ViewportPanel::draw_selection_box(Widgets& w, Frame& frame, const Rect& rect) {
  if (frame.status.click_line) {
    const OverlayLine& line = *frame.status.click_line;
    const ImVec2 a{rect.x + static_cast<float>(line.x0_px), rect.y + static_cast<float>(line.y0_px)};
    const ImVec2 b{rect.x + static_cast<float>(line.x1_px), rect.y + static_cast<float>(line.y1_px)};
    ImGui::GetWindowDrawList()->AddLine(a, b, w.tokens().accent.packed(), w.px(2));
  }
  if (!frame.status.selection_box) return;
  const Rect& box = *frame.status.selection_box;
  const Rect drawn{rect.x + box.x, rect.y + box.y, box.width, box.height};
  w.fill(drawn, w.tokens().accent.with_alpha(0.10f));
  w.outline(drawn, w.tokens().accent);
}

void ViewportPanel::draw_over_picture(Widgets& w, Frame& frame, const Rect& rect) {
  if (frame.status.measure_line) {
    const OverlayLine& line = *frame.status.measure_line;
    const ImVec2 a{rect.x + static_cast<float>(line.x0_px), rect.y + static_cast<float>(line.y0_px)};
    const ImVec2 b{rect.x + static_cast<float>(line.x1_px), rect.y + static_cast<float>(line.y1_px)};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddLine(a, b, w.tokens().accent.packed(), w.px(2));
    draw->AddCircleFilled(a, w.px(4), w.tokens().accent.packed());
    draw->AddCircleFilled(b, w.px(4), w.tokens().accent.packed());
  }
  draw_selection_box(w, frame, rect);
  draw_lines(w, frame, rect);
}

void ViewportPanel::draw_banner(Widgets& w, Frame& frame, const Rect& rect) {
  run_shape_keys(frame);
  const std::string text = banner_words(frame);
  if (text.empty()) return;
  const float width = std::min(w.text_width(text, TextRole::body) + w.px(32), rect.width - w.px(24));
  Rect plate{std::round(rect.center_x() - 0.5f * width), rect.bottom() - w.px(52), width, w.px(34)};
  if (plate.right() > rect.right() - w.px(150)) plate.y -= w.px(46);  // above the scale bar
  w.fill(plate, w.tokens().accent, w.px(12));
  w.text_in({plate.x + w.px(16), plate.y, plate.width - w.px(32), plate.height}, text, TextRole::body, Tone::on_accent, Align::center);
  w.record("viewport/banner", plate, text);
}

}  // namespace stemwise::ui
