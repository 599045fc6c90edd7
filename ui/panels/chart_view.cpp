#include "ui/panels/chart_view.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace stemwise::ui {

void draw_chart(Widgets& w, Frame& frame, Chart chart, const Rect& rect, const std::string& path) {
  const ChartView& view = frame.status.charts[static_cast<std::size_t>(chart)];
  const float x = std::round(rect.x), y = std::round(rect.y);
  ImGui::SetCursorScreenPos({x, y});
  ImGui::PushID(path.c_str());
  const bool clicked = ImGui::InvisibleButton("chart", {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)});
  ImGui::PopID();
  w.record_last(path, view.tip);
  const bool hovered = ImGui::IsItemHovered();
  if (view.texture != 0) {
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(view.texture)), {x, y},
                                         {x + static_cast<float>(view.width_px), y + static_cast<float>(view.height_px)});
  }
  request::ShowChart ask{chart, static_cast<int>(rect.width), static_cast<int>(rect.height)};
  if (hovered) {
    ask.x_px = ImGui::GetMousePos().x - x;
    ask.y_px = ImGui::GetMousePos().y - y;
    ask.clicked = clicked;
    if (!view.tip.empty()) w.tooltip(view.tip);
  }
  frame.requests.emit(ask);
}

}  // namespace stemwise::ui
