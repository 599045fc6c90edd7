#include "ui/panels/menu_bar.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <filesystem>

namespace stemwise::ui {
namespace {

bool is_on(const Frame& frame, ActionId id) {
  const ViewState& v = frame.view;
  switch (id) {
    case ActionId::view_links: return v.layers.links;
    case ActionId::view_residuals: return v.layers.residuals;
    case ActionId::view_coverage: return v.layers.coverage;
    case ActionId::view_grid: return v.layers.grid;
    case ActionId::view_labels: return v.layers.labels;
    case ActionId::view_underlays: return v.layers.underlays;
    case ActionId::view_left: return v.panels.show_left;
    case ActionId::view_right: return v.panels.show_right;
    case ActionId::view_bottom: return v.panels.show_bottom;
    case ActionId::view_theme: return v.theme == ThemeName::dark;
    case ActionId::view_reduce_motion: return v.reduce_motion;
    case ActionId::review_go_on: return v.goes_on;
    case ActionId::view_before_after: return v.before_after;
    case ActionId::view_ghost: return v.ghost;
    case ActionId::tool_lasso: return v.tool == Tool::lasso;
    case ActionId::edit_coverage: return v.tool == Tool::coverage;
    case ActionId::view_slide: return v.slide;
    case ActionId::view_blink: return v.blink;
    case ActionId::tool_select: return v.tool == Tool::select;
    case ActionId::tool_rectangle: return v.tool == Tool::rectangle;
    case ActionId::review_region: return v.queue.region.has_value();
    case ActionId::tool_measure: return v.tool == Tool::measure;
    default: break;
  }
  if (id >= ActionId::heat_density && id <= ActionId::heat_residual) {
    return static_cast<int>(id) - static_cast<int>(ActionId::heat_density) + 1 == static_cast<int>(v.heat);
  }
  if (id >= ActionId::color_inventory && id <= ActionId::color_times_seen) {
    return static_cast<int>(id) - static_cast<int>(ActionId::color_inventory) == static_cast<int>(v.color_by);
  }
  if (id >= ActionId::step_inventories && id <= ActionId::step_report) {
    return static_cast<int>(id) - static_cast<int>(ActionId::step_inventories) + 1 == static_cast<int>(v.step);
  }
  return false;
}

/// Actions of one kind that stand together in the menu behind one word; a menu is then short enough for a small window.
struct Submenu {
  const char* label;
  ActionId first, last;
};
constexpr std::array<Submenu, 6> submenus{{{"Layers", ActionId::view_links, ActionId::view_underlays},
                                           {"Panels", ActionId::view_left, ActionId::view_bottom},
                                           {"Colour by", ActionId::color_inventory, ActionId::color_times_seen},
                                           {"Heat map", ActionId::heat_density, ActionId::heat_residual},
                                           {"Tool", ActionId::tool_select, ActionId::tool_measure},
                                           {"Step", ActionId::step_inventories, ActionId::step_report}}};

const Submenu* submenu_of(ActionId id) {
  const auto found = std::find_if(submenus.begin(), submenus.end(), [id](const Submenu& s) { return id >= s.first && id <= s.last; });
  return found == submenus.end() ? nullptr : &*found;
}

/// Beside the menu, so that it covers none of the entries.
void draw_hint(Widgets& w, const std::string& text) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
  w.tooltip_at(right + w.px(4), ImGui::GetItemRectMin().y - w.px(4), text);
}

std::string label_of(const Frame& frame, const Action& action) {
  const std::string what = action.id == ActionId::edit_undo ? frame.project.undo_label()
                           : action.id == ActionId::edit_redo ? frame.project.redo_label() : "";
  return what.empty() ? action.label : std::string(action.label) + ": " + what;
}

}  // namespace

std::string submenu_label(ActionId id) {
  const Submenu* sub = submenu_of(id);
  return sub == nullptr ? "" : sub->label;
}

void MenuBar::draw(Widgets& w, Frame& frame) {
  const float pad_y = 0.5f * (w.px(height) - w.line_height(TextRole::body));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {w.px(10), pad_y});
  if (ImGui::BeginMenuBar()) {
    ImGui::SetCursorPosX(w.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(18), w.px(8)});
    for (std::size_t i = 0; i < menu_count; ++i) draw_menu(w, frame, static_cast<Menu>(i));
    ImGui::PopStyleVar();
    const std::string right = frame.status.project_title + (frame.status.saved_text.empty() ? "" : " · " + frame.status.saved_text);
    const ImVec2 at = ImGui::GetWindowPos();
    const Rect rect{at.x + ImGui::GetWindowWidth() * 0.5f, at.y, ImGui::GetWindowWidth() * 0.5f - w.px(16), w.px(height)};
    w.text_in(rect, right, TextRole::table, Tone::secondary, Align::right);
    w.record("menu/title", rect, right);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar();
}

void MenuBar::draw_menu(Widgets& w, Frame& frame, Menu menu) {
  // Below the bar whatever its length: one that covered the bar would take the click that opened it for a choice.
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, std::max(w.px(120), ImGui::GetIO().DisplaySize.y - w.px(height + 12))});
  const bool open = ImGui::BeginMenu(menu_label(menu));
  w.record_last(std::string("menu/") + menu_label(menu), menu_label(menu));
  if (!open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(8), w.px(9)});
  for (const Action& action : all_actions()) {
    if (action.menu != menu) continue;
    const Submenu* sub = submenu_of(action.id);
    if (action.separator_before && (sub == nullptr || sub == &submenus.front())) ImGui::Separator();
    if (sub == nullptr) {
      draw_item(w, frame, action);
    } else if (action.id == sub->first) {
      draw_submenu(w, frame, sub->label, sub->first, sub->last);
    }
    if (action.id == ActionId::file_open) draw_recent(w, frame);
  }
  ImGui::PopStyleVar();
  ImGui::EndMenu();
}

void MenuBar::draw_submenu(Widgets& w, Frame& frame, const char* label, ActionId first, ActionId last) {
  const bool open = ImGui::BeginMenu(label);
  w.record_last(std::string("menu/more/") + label, label);
  if (!open) return;
  for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) draw_item(w, frame, action(static_cast<ActionId>(i)));
  ImGui::EndMenu();
}

void MenuBar::draw_item(Widgets& w, Frame& frame, const Action& action) {
  const std::string& why_not = frame.available[static_cast<std::size_t>(action.id)].why_not;
  const std::string chord = "    " + to_string(action.chord);
  if (ImGui::MenuItem(label_of(frame, action).c_str(), chord.c_str(), is_on(frame, action.id), why_not.empty())) frame.requests.run(action.id);
  w.record_last(std::string("menu/") + action.name, action.label, why_not.empty());
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) draw_hint(w, why_not.empty() ? action.help : why_not);
}

void MenuBar::draw_recent(Widgets& w, Frame& frame) {
  const std::vector<std::string>& recent = frame.status.recent_projects;
  if (!ImGui::BeginMenu("Open recent", !recent.empty() && frame.can(ActionId::file_open))) return;
  for (const std::string& path : recent) {
    if (ImGui::MenuItem(std::filesystem::path(path).filename().c_str())) frame.requests.emit(request::OpenProject{path});
    w.record_last("menu/recent/" + path, path);
    if (ImGui::IsItemHovered()) w.tooltip(path);
  }
  ImGui::EndMenu();
}

}  // namespace stemwise::ui
