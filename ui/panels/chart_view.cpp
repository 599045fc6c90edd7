#include "ui/panels/chart_view.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace stemwise::ui {
namespace {

constexpr float least_drag_px = 5.0f;

}  // namespace

void draw_chart(Widgets& w, Frame& frame, Chart chart, const Rect& rect, const std::string& path) {
  const ChartView& view = frame.status.charts[static_cast<std::size_t>(chart)];
  const float x = std::round(rect.x), y = std::round(rect.y);
  ImGui::SetCursorScreenPos({x, y});
  ImGui::PushID(path.c_str());
  ImGui::InvisibleButton("chart", {std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)});
  ImGui::PopID();
  w.record_last(path, view.tip);
  if (view.texture != 0) {
    ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(view.texture)), {x, y},
                                         {x + static_cast<float>(view.width_px), y + static_cast<float>(view.height_px)});
  }
  request::ShowChart ask{chart, static_cast<int>(rect.width), static_cast<int>(rect.height)};
  const ImVec2 mouse = ImGui::GetMousePos(), from = ImGui::GetIO().MouseClickedPos[0];
  const bool dragged = std::hypot(mouse.x - from.x, mouse.y - from.y) >= least_drag_px;
  if (ImGui::IsItemActive() && dragged) {
    const Rect box{std::min(from.x, mouse.x), std::min(from.y, mouse.y), std::abs(mouse.x - from.x), std::abs(mouse.y - from.y)};
    w.fill(box, w.tokens().accent.with_alpha(0.10f));
    w.outline(box, w.tokens().accent);
  }
  const bool released = ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(0);
  if (ImGui::IsItemHovered() || released) {
    ask.x_px = mouse.x - x;
    ask.y_px = mouse.y - y;
    ask.adds = ImGui::GetIO().KeyCtrl;
    ask.clicked = released && !dragged;
    if (released && dragged) {
      ask.from_x_px = from.x - x;
      ask.from_y_px = from.y - y;
    }
    if (!view.tip.empty() && !dragged) w.tooltip(view.tip);
  }
  frame.requests.emit(ask);
}

}  // namespace stemwise::ui
