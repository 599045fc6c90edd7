#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string_view>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {
namespace {

constexpr const char* ellipsis = "…";

/// The longest beginning (whole UTF-8 characters) that fits, with an ellipsis.
std::string shortened(ImFont* font, const std::string& text, float width) {
  const float room = width - font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, ellipsis).x;
  const char* end = nullptr;
  font->CalcTextSizeA(font->FontSize, std::max(room, 1.0f), 0.0f, text.data(), text.data() + text.size(), &end);
  return std::string(text.data(), end) + ellipsis;
}

/// Broken at spaces where it is wider, and at line ends; an empty text has one empty line.
std::vector<std::string_view> wrapped_lines(ImFont* font, const std::string& text, float width) {
  std::vector<std::string_view> lines;
  const char* at = text.data();
  const char* const end = at + text.size();
  do {
    const char* stop = std::find(at, end, '\n');
    const char* line_end = std::max(font->CalcWordWrapPositionA(1.0f, at, stop, std::max(width, 1.0f)), std::min(at + 1, stop));
    lines.emplace_back(at, line_end);
    at = line_end;
    while (at < stop && *at == ' ') ++at;
    if (at == stop && at < end) ++at;
  } while (at < end);
  return lines;
}

}  // namespace

Color Widgets::color(Tone tone) const {
  const Tokens& t = tokens();
  switch (tone) {
    case Tone::text: return t.text;
    case Tone::secondary: return t.secondary;
    case Tone::faint: return t.faint;
    case Tone::accent: return t.accent;
    case Tone::on_accent: return t.on_accent;
    case Tone::warning: return t.warning;
    case Tone::error: return t.error;
  }
  return t.text;
}

void Widgets::push_font(TextRole role) { ImGui::PushFont(fonts.of(role)); }
void Widgets::pop_font() { ImGui::PopFont(); }

void Widgets::text(const std::string& text, TextRole role, Tone tone) {
  push_font(role);
  ImGui::PushStyleColor(ImGuiCol_Text, color(tone).packed());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  pop_font();
}

void Widgets::paragraph(const std::string& text, TextRole role, Tone tone) {
  const float width = available_width();
  const Rect block = next_rect(width, wrapped_height(text, role, width));
  wrapped_in(block, text, role, tone);
  ImGui::Dummy({width, block.height});
}

float Widgets::line_step(TextRole role) const { return std::round(1.2f * fonts.of(role)->FontSize); }

float Widgets::wrapped_height(const std::string& text, TextRole role, float width_px) const {
  const auto lines = static_cast<float>(wrapped_lines(fonts.of(role), text, width_px).size());
  return line_height(role) + (lines - 1.0f) * line_step(role);
}

void Widgets::wrapped_in(const Rect& rect, const std::string& text, TextRole role, Tone tone) {
  ImFont* font = fonts.of(role);
  float y = std::round(rect.y);
  for (const std::string_view line : wrapped_lines(font, text, rect.width)) {
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {std::round(rect.x), y}, color(tone).packed(), line.data(), line.data() + line.size());
    y += line_step(role);
  }
}

std::string Widgets::middle_shortened(const std::string& text, TextRole role, float width_px) const {
  if (text_width(text, role) <= width_px) return text;
  const auto is_inside_character = [&](std::size_t i) { return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  std::size_t head = text.size() / 2, tail = head;
  std::string shown = text;
  while (head > 1 || text.size() - tail > 1) {
    if (head >= text.size() - tail) {
      do --head;
      while (is_inside_character(head));
    } else {
      do ++tail;
      while (is_inside_character(tail));
    }
    shown = text.substr(0, head) + ellipsis + text.substr(tail);
    if (text_width(shown, role) <= width_px) break;
  }
  return shown;
}

void Widgets::section(const std::string& title) {
  gap(8);
  text(middle_shortened(title, TextRole::strong, available_width()), TextRole::strong);
}

void Widgets::fact(const std::string& path, const std::string& name, const std::string& value, const std::string& tooltip_text) {
  const Rect row = next_rect(available_width(), px(24));
  const float value_width = std::min(text_width(value, TextRole::body) + px(2), row.width * 0.72f);
  text_in({row.x, row.y, row.width - value_width - px(6), row.height}, name, TextRole::body, Tone::secondary);
  text_in({row.right() - value_width, row.y, value_width, row.height}, value, TextRole::body, Tone::text, Align::right);
  ImGui::Dummy({row.width, row.height - ImGui::GetStyle().ItemSpacing.y});
  record(path, row, value);
  if (!tooltip_text.empty() && ImGui::IsWindowHovered() && row.contains(ImGui::GetMousePos().x, ImGui::GetMousePos().y)) tooltip(tooltip_text);
}

float Widgets::text_width(const std::string& text, TextRole role) const {
  ImFont* font = fonts.of(role);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size()).x;
}

float Widgets::line_height(TextRole role) const { return fonts.of(role)->FontSize; }

void Widgets::text_in(const Rect& rect, const std::string& text, TextRole role, Tone tone, Align align) {
  text_in(rect, text, role, color(tone), align);
}

void Widgets::text_in(const Rect& rect, const std::string& text, TextRole role, Color ink, Align align) {
  ImFont* font = fonts.of(role);
  const float full = text_width(text, role);
  const bool fits = full <= rect.width + 0.5f;
  const std::string shown = fits ? text : shortened(font, text, rect.width);
  const float width = fits ? full : text_width(shown, role);
  float x = rect.x;
  if (align == Align::center) x = rect.center_x() - 0.5f * width;
  if (align == Align::right) x = rect.right() - width;
  const float y = rect.y + 0.5f * (rect.height - font->FontSize);
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {std::round(x), std::round(y)}, ink.packed(), shown.data(),
                                      shown.data() + shown.size());
  const ImVec2 mouse = ImGui::GetMousePos();
  if (!fits && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && rect.contains(mouse.x, mouse.y)) tooltip(text);
}

void Widgets::tooltip_at(float x, float y, const std::string& text) {
  ImGui::SetNextWindowPos({x, y});
  tooltip(text);
}

void Widgets::tooltip(const std::string& text) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(10), px(7)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(360));
  this->text(text, TextRole::body, Tone::text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
