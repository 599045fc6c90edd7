#include "ui/panels/underlay_list.hpp"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

namespace stemwise::ui {
namespace {

constexpr float list_width = 300.0f;
constexpr float label_width = 74.0f;

void draw_label(Widgets& w, const char* text) {
  const Rect row = w.next_rect(w.px(label_width), w.px(28));
  w.text_in(row, text, TextRole::table, Tone::secondary);
  ImGui::SetCursorScreenPos({row.right(), row.y});
}

void draw_heights(Widgets& w, Underlay& u, const std::string& path) {
  const float width = 0.5f * (w.px(list_width - label_width) - w.px(6));
  draw_label(w, "Heights");
  const char* low = u.low_m <= Underlay::lowest_m ? "from lowest" : "from %.1f m";
  if (w.slider(path + "/from", u.low_m, Underlay::lowest_m, Underlay::highest_m, low, width)) u.high_m = std::max(u.high_m, u.low_m);
  if (ImGui::IsItemHovered()) w.tooltip("Only points so high above the ground are shown: 0.8 to 1.8 m shows the stems alone. The ground is where the cloud's lowest points are.");
  ImGui::SameLine(0, w.px(6));
  const char* high = u.high_m >= Underlay::highest_m ? "to highest" : "to %.1f m";
  if (w.slider(path + "/to", u.high_m, Underlay::lowest_m, Underlay::highest_m, high, width)) u.low_m = std::min(u.low_m, u.high_m);
}

void draw_shade(Widgets& w, Underlay& u, const std::string& path) {
  std::vector<CloudShade> shades{CloudShade::height};
  std::vector<std::string> names{"height above ground"};
  if (u.has_intensity) shades.push_back(CloudShade::intensity), names.push_back("intensity");
  if (u.has_colour) shades.push_back(CloudShade::colour), names.push_back("colours of the file");
  if (shades.size() < 2) return;
  draw_label(w, "Shade by");
  int current = static_cast<int>(std::find(shades.begin(), shades.end(), u.shade) - shades.begin());
  if (w.combo(path + "/shade", names, current, w.px(list_width - label_width))) u.shade = shades[static_cast<std::size_t>(current)];
}

/// Whose coordinates a file has that names no coordinate system.
void draw_frame(Widgets& w, const Frame& frame, Underlay& u, const std::string& path) {
  std::vector<InventoryId> ids;
  std::vector<std::string> names;
  for (const auto& inventory : frame.state().inventories) {
    if (!frame.state().is_placed(inventory->id)) continue;
    ids.push_back(inventory->id);
    names.push_back(survey_label(frame.state(), inventory->id));
  }
  if (ids.size() < 2) return;
  draw_label(w, "Lies with");
  int current = static_cast<int>(std::find(ids.begin(), ids.end(), u.frame) - ids.begin());
  if (w.combo(path + "/frame", names, current, w.px(list_width - label_width))) u.frame = ids[static_cast<std::size_t>(current)];
  if (ImGui::IsItemHovered()) w.tooltip("The file names no coordinate system: its coordinates are those of this survey");
}

void draw_underlay(Widgets& w, Frame& frame, Underlay& u) {
  const std::string path = "underlay/" + std::to_string(u.id);
  const std::string name = std::filesystem::path(u.path).filename().string();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  w.checkbox(path, w.middle_shortened(name, TextRole::body, w.px(list_width - 60)), u.visible, u.path + (u.is_cloud ? "" : "\nUnder the stems of the map; in 3D on the ground."));
  if (w.button_in({at.x + w.px(list_width - 26), at.y, w.px(26), w.px(24)}, path + "/remove", "", {.quiet = true, .icon = icon::cross, .tooltip = "Take it away; the file stays"})) {
    frame.requests.emit(request::RemoveUnderlay{u.id});
  }
  ImGui::SetCursorScreenPos({at.x, at.y + w.px(28)});
  if (!u.about.empty()) {
    const float height = w.wrapped_height(u.about, TextRole::caption, w.px(list_width));
    const Rect row = w.next_rect(w.px(list_width), height);
    w.wrapped_in(row, u.about, TextRole::caption, u.state == Underlay::State::failed ? Tone::error : Tone::secondary);
    w.record(path + "/about", row, u.about);
    ImGui::SetCursorScreenPos({row.x, row.bottom() + w.px(4)});
  }
  if (u.state != Underlay::State::shown) return;
  float percent = 100.0f * u.opacity;
  draw_label(w, "Opacity");
  if (w.slider(path + "/opacity", percent, 5.0f, 100.0f, "%.0f %%", w.px(list_width - label_width))) u.opacity = 0.01f * percent;
  if (u.is_local) draw_frame(w, frame, u, path);
  if (!u.is_cloud) return;
  draw_heights(w, u, path);
  draw_shade(w, u, path);
}

}  // namespace

void draw_underlays(Widgets& w, Frame& frame) {
  w.gap(6);
  w.text("Underlays", TextRole::caption, Tone::secondary);
  std::vector<Underlay>& all = frame.view.underlays;
  if (all.size() > 1) w.checkbox("layers/underlays", "Show underlays", frame.view.layers.underlays);
  for (auto u = all.rbegin(); u != all.rend(); ++u) {  // the uppermost first, as they lie
    draw_underlay(w, frame, *u);
    w.gap(4);
  }
  w.action_button("layers/add-underlay", ActionId::file_underlay, frame.available, frame.requests, {.width = w.px(list_width)});
}

}  // namespace stemwise::ui
