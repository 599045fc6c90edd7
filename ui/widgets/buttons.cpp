#include <imgui.h>

#include <algorithm>

#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {
namespace {

constexpr float button_height = 30.0f;

}  // namespace

void Widgets::draw_button(const Rect& rect, const std::string& label, const ButtonLook& look, bool hovered, bool held) {
  const Tokens& t = tokens();
  const bool enabled = look.why_not.empty();
  const float rounding = px(6);
  if (!look.quiet) {
    const Color base = look.primary && enabled ? t.accent : look.active ? t.accent_soft : look.plate ? t.panel : t.canvas;
    fill(rect, base, rounding);
    if (!look.primary || !enabled) outline(rect, look.active ? t.accent : t.line, rounding);
  }
  if (hovered && enabled) fill(rect, look.primary ? t.text.with_alpha(held ? 0.22f : 0.12f) : t.hover, rounding);
  if (held && enabled && !look.primary) fill(rect, t.hover, rounding);

  Color ink = look.primary ? t.on_accent : look.active || look.quiet ? t.accent : t.text;
  if (!enabled) ink = t.faint;
  const float pad = label.empty() ? 0.0f : px(look.quiet || rect.width < px(64) ? 4 : 12);
  const std::string shown = look.icon != nullptr ? std::string(look.icon) + (label.empty() ? "" : "  " + label) : label;
  const Rect inner{rect.x + pad, rect.y, rect.width - 2 * pad, rect.height};
  if (look.key.empty()) {
    text_in(inner, shown, TextRole::strong, ink, Align::center);
    return;
  }
  const float key_width = text_width(look.key, TextRole::caption);
  text_in({inner.x, inner.y, inner.width - key_width - px(6), inner.height}, shown, TextRole::strong, ink);
  const Color key_ink = look.primary && enabled ? t.on_accent.with_alpha(0.85f) : enabled ? t.secondary : t.faint;
  text_in(inner, look.key, TextRole::caption, key_ink, Align::right);
}

bool Widgets::button_in(const Rect& rect, const std::string& path, const std::string& label, const ButtonLook& look) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushID(path.c_str());
  const bool pressed = ImGui::InvisibleButton("button", {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)});
  ImGui::PopID();
  const bool enabled = look.why_not.empty();
  const bool hovered = ImGui::IsItemHovered();
  record_last(path, label, enabled);
  draw_button(rect, label, look, hovered, ImGui::IsItemActive());
  focus_ring(rect);
  if (hovered && enabled) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const std::string& hint = enabled ? look.tooltip : look.why_not;
  if (hovered && !hint.empty()) tooltip(hint);
  return pressed && enabled;
}

bool Widgets::button(const std::string& path, const std::string& label, const ButtonLook& look) {
  float width = look.width;
  if (width == 0.0f) {
    width = text_width(label, TextRole::strong) + px(look.quiet ? 8 : 24);
    if (look.icon != nullptr) width += text_width(std::string(look.icon) + (label.empty() ? "" : "  "), TextRole::strong);
    if (!look.key.empty()) width += text_width(look.key, TextRole::caption) + px(14);
  } else if (width < 0.0f) {
    width = available_width();
  }
  return button_in(next_rect(width, px(look.quiet ? 24 : button_height)), path, label, look);
}

namespace {

ButtonLook with_action(ButtonLook look, ActionId id, const Availabilities& available) {
  const Action& a = action(id);
  look.key = look.quiet || look.icon != nullptr ? "" : to_string(a.chord);
  look.why_not = available[static_cast<std::size_t>(id)].why_not;
  look.tooltip = (look.tooltip.empty() ? std::string(a.help) : look.tooltip) + (a.chord == KeyChord{} ? "" : "  (" + to_string(a.chord) + ")");
  return look;
}

}  // namespace

void Widgets::action_button(const std::string& path, ActionId id, const Availabilities& available, Requests& requests, ButtonLook look) {
  if (button(path, action(id).label, with_action(std::move(look), id, available))) requests.run(id);
}

void Widgets::action_button_in(const Rect& rect, const std::string& path, ActionId id, const Availabilities& available, Requests& requests,
                               ButtonLook look) {
  if (button_in(rect, path, action(id).label, with_action(std::move(look), id, available))) requests.run(id);
}

bool Widgets::fold(const std::string& path, const std::string& label, bool& open) {
  const Rect row = next_rect(available_width(), px(28));
  if (area(path, row, open ? "open" : "closed")) open = !open;
  text_in({row.x, row.y, px(18), row.height}, open ? icon::caret_down : icon::caret_right, TextRole::body, Tone::secondary);
  text_in({row.x + px(18), row.y, row.width - px(18), row.height}, label, TextRole::strong, Tone::text);
  return open;
}

}  // namespace stemwise::ui
