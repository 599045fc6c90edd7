#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "ui/text/number_from_text.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {
namespace {

constexpr float field_height = 28.0f;

/// Makes a one-line field as high as every other control of a form.
class FieldPadding {
 public:
  explicit FieldPadding(const Widgets& w) {
    const float y = std::max(1.0f, 0.5f * (w.px(field_height) - ImGui::GetFontSize()));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {w.px(10), y});
  }
  ~FieldPadding() { ImGui::PopStyleVar(); }
  FieldPadding(const FieldPadding&) = delete;
  FieldPadding& operator=(const FieldPadding&) = delete;
};

}  // namespace

bool Widgets::checkbox(const std::string& path, const std::string& label, bool& value, const std::string& hint) {
  const Rect row = next_rect(px(16) + px(8) + text_width(label, TextRole::body) + px(4), px(24));
  const bool pressed = area(path, row, value ? "on" : "off");
  if (ImGui::IsItemHovered() && !hint.empty()) tooltip(hint);
  if (pressed) value = !value;
  const Rect box{row.x + px(1), row.center_y() - px(8), px(16), px(16)};
  fill(box, value ? tokens().accent : tokens().canvas, px(4));
  outline(box, value ? tokens().accent : tokens().line, px(4));
  if (value) text_in(box, icon::check, TextRole::caption, Tone::on_accent, Align::center);
  text_in({box.right() + px(8), row.y, row.width, row.height}, label, TextRole::body, Tone::text);
  return pressed;
}

/// Below its field, or above it where the window ends; wide enough for every item.
void Widgets::place_list(const Rect& field, const std::vector<std::string>& items) const {
  float widest = field.width;
  const std::size_t measured = std::min<std::size_t>(items.size(), 60);
  for (std::size_t i = 0; i < measured; ++i) widest = std::max(widest, text_width(items[i], TextRole::body) + px(34));
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float wanted = std::min(px(320), static_cast<float>(items.size()) * (px(22) + ImGui::GetStyle().ItemSpacing.y) + px(12));
  const float below = screen.y - field.bottom() - px(6), above = field.y - px(6);
  const bool down = wanted <= below || below >= above;
  const float height = std::min(wanted, down ? below : above);
  const float x = std::max(px(4), std::min(field.x, screen.x - widest - px(4)));
  ImGui::SetNextWindowPos({x, down ? field.bottom() + px(2) : field.y - px(2)}, ImGuiCond_Always, {0.0f, down ? 0.0f : 1.0f});
  ImGui::SetNextWindowSizeConstraints({widest, 0}, {widest, height});
}

bool Widgets::combo(const std::string& path, const std::vector<std::string>& items, int& current, float width_px) {
  const float width = width_px > 0.0f ? width_px : available_width();
  const bool known = current >= 0 && current < static_cast<int>(items.size());
  const Rect rect = next_rect(width, px(28));
  ImGui::PushID(path.c_str());
  const bool pressed = ImGui::InvisibleButton("combo", {rect.width, rect.height});
  const bool hovered = ImGui::IsItemHovered();
  record_last(path, known ? items[static_cast<std::size_t>(current)] : "");
  fill(rect, tokens().canvas, px(6));
  outline(rect, tokens().line, px(6));
  if (hovered) fill(rect, tokens().hover, px(6));
  focus_ring(rect);
  text_in({rect.x + px(10), rect.y, rect.width - px(32), rect.height}, known ? items[static_cast<std::size_t>(current)] : "", TextRole::body, Tone::text);
  text_in({rect.right() - px(25), rect.y, px(18), rect.height}, icon::caret_down, TextRole::caption, Tone::secondary, Align::center);
  if (pressed) ImGui::OpenPopup("items");
  bool changed = false;
  place_list(rect, items);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(6), px(6)});
  if (ImGui::BeginPopup("items")) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (ImGui::Selectable(items[i].c_str(), static_cast<int>(i) == current, 0, {0, px(22)})) {
        current = static_cast<int>(i);
        changed = true;
      }
      record_last(path + "/" + items[i], items[i]);
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool Widgets::input(const std::string& path, std::string& value, const InputLook& look) {
  const float width = look.width > 0.0f ? look.width : available_width();
  ImGui::PushID(path.c_str());
  ImGui::BeginDisabled(!look.why_not.empty());
  bool changed = false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (look.lines > 1) {
    changed = ImGui::InputTextMultiline("##text", &value, {width, px(18.0f * static_cast<float>(look.lines) + 10.0f)});
    if (value.empty() && !ImGui::IsItemActive()) {
      ImGui::GetWindowDrawList()->AddText({at.x + px(10), at.y + px(7)}, tokens().faint.packed(), look.hint.c_str());
    }
  } else {
    const FieldPadding padding(*this);
    ImGui::SetNextItemWidth(width);
    changed = ImGui::InputTextWithHint("##text", look.hint.c_str(), &value);
  }
  ImGui::EndDisabled();
  record_last(path, value, look.why_not.empty(), true);
  if (ImGui::IsItemActive()) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    outline({low.x, low.y, high.x - low.x, high.y - low.y}, tokens().accent, px(6));
  }
  if (!look.why_not.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) tooltip(look.why_not);
  ImGui::PopID();
  return changed;
}

bool Widgets::path_field(const std::string& path, std::string& value, const std::string& browse_path, const InputLook& look) {
  const Rect line = next_rect(available_width(), px(field_height));
  const float button_width = px(84);
  InputLook narrower = look;
  narrower.width = line.width - button_width - px(8);
  input(path, value, narrower);
  if (ImGui::IsItemHovered() && text_width(value, TextRole::body) > narrower.width - px(20)) tooltip(value);
  return button_in({line.right() - button_width, line.y, button_width, line.height}, browse_path, "Browse…");
}

bool Widgets::number(const std::string& path, double& value, const char* format, float width_px, const char* at_zero) {
  const FieldPadding padding(*this);
  ImGui::PushID(path.c_str());
  ImGui::SetNextItemWidth(width_px > 0.0f ? width_px : available_width());
  std::array<char, 64> text{};
  if (at_zero == nullptr || value != 0.0) std::snprintf(text.data(), text.size(), format, value);
  const double before = value;
  if (ImGui::InputTextWithHint("##number", at_zero == nullptr ? "" : at_zero, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll)) {
    const bool is_cleared = at_zero != nullptr && text.front() == '\0';
    const std::optional<double> typed = is_cleared ? std::optional(0.0) : number_from_text(text.data());
    value = typed.value_or(value_before_typing_);
    refused_ = typed ? Refused{} : Refused{path, text.data()};
  }
  if (ImGui::IsItemActivated()) {
    value_before_typing_ = before;
    refused_ = {};
  }
  record_last(path, std::to_string(value), true, true);
  if (refused_.path == path) draw_refused(path);
  ImGui::PopID();
  return value != before;
}

/// Stays until a number is typed in this field or in another one.
void Widgets::draw_refused(const std::string& path) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const Rect rect{low.x, low.y, high.x - low.x, high.y - low.y};
  outline(rect, tokens().warning, px(6));
  record(path + "/refused", rect, refused_.text);
  tooltip_at(low.x, high.y + px(4), "\"" + refused_.text + "\" is no number: the value stays as it was.");
}

bool Widgets::slider(const std::string& path, float& value, float low, float high, const char* format, float width_px) {
  const FieldPadding padding(*this);
  ImGui::PushID(path.c_str());
  ImGui::SetNextItemWidth(width_px > 0.0f ? width_px : available_width());
  const bool changed = ImGui::SliderFloat("##slider", &value, low, high, format, ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);  // typing there would drop a decimal comma
  record_last(path, std::to_string(value));
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  outline({from.x, from.y, to.x - from.x, to.y - from.y}, ImGui::IsItemActive() ? tokens().accent : tokens().line, px(6));
  ImGui::PopID();
  return changed;
}

}  // namespace stemwise::ui
