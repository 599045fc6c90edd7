#include "ui/theme/style.hpp"

#include <imgui.h>

namespace stemwise::ui {
namespace {

ImVec4 vec(Color c) { return {c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f}; }

void set_sizes(ImGuiStyle& s) {
  s.WindowPadding = {16, 12};
  s.FramePadding = {10, 6};
  s.ItemSpacing = {8, 8};
  s.ItemInnerSpacing = {8, 4};
  s.CellPadding = {8, 4};
  s.WindowRounding = 8;
  s.ChildRounding = 0;
  s.PopupRounding = 8;
  s.FrameRounding = 6;
  s.GrabRounding = 6;
  s.ScrollbarRounding = 6;
  s.ScrollbarSize = 10;
  s.GrabMinSize = 24;
  s.WindowBorderSize = 1;
  s.PopupBorderSize = 1;
  s.FrameBorderSize = 1;
  s.ChildBorderSize = 0;
  s.IndentSpacing = 16;
}

void set_surfaces(ImVec4* c, const Tokens& t) {
  c[ImGuiCol_Text] = vec(t.text);
  c[ImGuiCol_TextDisabled] = vec(t.faint);
  c[ImGuiCol_WindowBg] = vec(t.panel);
  c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_PopupBg] = vec(t.panel);
  c[ImGuiCol_Border] = vec(t.line);
  c[ImGuiCol_BorderShadow] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_MenuBarBg] = vec(t.background);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = vec(t.background);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.38f);
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = vec(t.line);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = vec(t.faint);
  c[ImGuiCol_TableHeaderBg] = vec(t.panel);
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = vec(t.line);
  c[ImGuiCol_TableRowBg] = c[ImGuiCol_TableRowBgAlt] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_Separator] = vec(t.line);
}

void set_controls(ImVec4* c, const Tokens& t) {
  c[ImGuiCol_FrameBg] = vec(t.canvas);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_FrameBgActive] = vec(t.canvas);
  c[ImGuiCol_Button] = vec(t.canvas);
  c[ImGuiCol_ButtonHovered] = c[ImGuiCol_ButtonActive] = vec(t.accent_soft);
  c[ImGuiCol_Header] = c[ImGuiCol_HeaderActive] = vec(t.accent_soft);
  c[ImGuiCol_HeaderHovered] = vec(t.hover);  // what the mouse is over is not what is selected
  c[ImGuiCol_CheckMark] = vec(t.accent);
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = vec(t.accent);
  c[ImGuiCol_TextSelectedBg] = vec(t.accent.with_alpha(0.30f));
  c[ImGuiCol_NavHighlight] = vec(t.accent);
  c[ImGuiCol_DragDropTarget] = vec(t.accent);
}

}  // namespace

void apply_style(const Theme& theme) {
  ImGuiStyle style;
  set_sizes(style);
  style.ScaleAllSizes(theme.scale);
  style.WindowBorderSize = style.PopupBorderSize = style.FrameBorderSize = 1;
  set_surfaces(style.Colors, theme.tokens());
  set_controls(style.Colors, theme.tokens());
  ImGui::GetStyle() = style;
}

}  // namespace stemwise::ui
