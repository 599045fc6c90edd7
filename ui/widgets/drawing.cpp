#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

void Widgets::fill(const Rect& r, Color c, float rounding) {
  ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.right(), r.bottom()}, c.packed(), rounding);
}

void Widgets::outline(const Rect& r, Color c, float rounding) {
  ImGui::GetWindowDrawList()->AddRect({r.x, r.y}, {r.right(), r.bottom()}, c.packed(), rounding);
}

void Widgets::hairline(float x0, float y0, float x1, float y1) {
  // A filled rectangle keeps the line one pixel wide and sharp.
  const float width = std::max(x1 - x0, 1.0f);
  const float height = std::max(y1 - y0, 1.0f);
  fill({x0, y0, width, height}, tokens().line);
}

void Widgets::gap(float height_at_100_percent) { ImGui::Dummy({0.0f, std::max(0.0f, px(height_at_100_percent) - ImGui::GetStyle().ItemSpacing.y)}); }

float Widgets::available_width() const { return ImGui::GetContentRegionAvail().x; }

Rect Widgets::next_rect(float width_px, float height_px) const {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  return {at.x, at.y, width_px, height_px};
}

void Widgets::record_last(const std::string& path, const std::string& value, bool enabled, bool is_text, bool by_tab) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  registry.record(path, {{low.x, low.y, high.x - low.x, high.y - low.y}, ImGui::IsItemVisible(), enabled, value});
  if (enabled && by_tab) focus.visit(path, is_text);
}

void Widgets::record(const std::string& path, const Rect& rect, const std::string& value, bool enabled) {
  const ImRect clip = ImGui::GetCurrentWindow()->ClipRect;
  const bool visible = clip.Overlaps(ImRect(rect.x, rect.y, rect.right(), rect.bottom()));
  registry.record(path, {rect, visible, enabled, value});
}

void Widgets::focus_ring(const Rect& rect) {
  if (!ImGui::IsItemFocused() || GImGui->NavDisableHighlight) return;
  const ImRect clip = ImGui::GetCurrentWindow()->ClipRect;  // a ring that is cut off looks broken: it stays inside its panel
  const ImVec2 low{std::max(rect.x - 2, clip.Min.x + 1), std::max(rect.y - 2, clip.Min.y + 1)};
  const ImVec2 high{std::min(rect.right() + 2, clip.Max.x - 1), std::min(rect.bottom() + 2, clip.Max.y - 1)};
  if (high.x > low.x && high.y > low.y) ImGui::GetWindowDrawList()->AddRect(low, high, tokens().accent.packed(), px(7), 0, 2.0f);
}

bool Widgets::area(const std::string& path, const Rect& rect, const std::string& value, bool rounded) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushID(path.c_str());
  const bool pressed = ImGui::InvisibleButton("area", {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)});
  ImGui::PopID();
  record_last(path, value);
  if (ImGui::IsItemHovered()) {
    fill(rect, tokens().hover, rounded ? px(6) : 0.0f);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  focus_ring(rect);
  return pressed;
}

void Widgets::pill(const std::string& path, const std::string& label, Color c, float right_x, float y) {
  const float width = text_width(label, TextRole::strong) + px(28);
  const Rect rect{right_x - width, y, width, px(24)};
  fill(rect, c, px(12));
  // Dark ink on the light fates: the text must be readable on every fate's colour.
  const float luminance = 0.299f * static_cast<float>(c.r) + 0.587f * static_cast<float>(c.g) + 0.114f * static_cast<float>(c.b);
  text_in(rect, label, TextRole::strong, luminance > 150.0f ? hex(0x14211A) : hex(0xFFFFFF), Align::center);
  record(path, rect, label);
}

void Widgets::progress_bar(const Rect& rect, double fraction) {
  fill(rect, tokens().canvas, 0.5f * rect.height);
  outline(rect, tokens().line, 0.5f * rect.height);
  const float width = rect.width * static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  if (width > rect.height) fill({rect.x, rect.y, width, rect.height}, tokens().accent, 0.5f * rect.height);
}

bool Widgets::splitter(const std::string& path, const Rect& rect, bool vertical, float& size, float min, float max, bool grows_back) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushID(path.c_str());
  ImGui::InvisibleButton("splitter", {rect.width, rect.height});
  ImGui::PopID();
  record_last(path, std::to_string(static_cast<int>(size)));
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const Rect line = vertical ? Rect{rect.center_x() - 1, rect.y, 2, rect.height} : Rect{rect.x, rect.center_y() - 1, rect.width, 2};
    fill(line, tokens().accent);
  }
  if (!active) return false;
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const float moved = (vertical ? delta.x : delta.y) / theme.scale;
  size = std::clamp(size + (grows_back ? -moved : moved), min, max);
  return true;
}

}  // namespace stemwise::ui
