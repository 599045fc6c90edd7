#include "ui/panels/empty_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace stemwise::ui {
namespace {

/// Three rings of one tree, grown from survey to survey.
void draw_mark(Widgets& w, float x, float y) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float radii[] = {26.0f, 18.0f, 10.0f};
  for (std::size_t i = 0; i < 3; ++i) {
    const Color ring = survey_color(2 - i);
    draw->AddCircleFilled({x, y}, w.px(radii[i]), ring.with_alpha(0.16f).packed(), 64);
    draw->AddCircle({x, y}, w.px(radii[i]), ring.packed(), 64, w.px(2));
  }
}

}  // namespace

void EmptyState::draw(Widgets& w, Frame& frame, const Rect& rect) {
  w.fill(rect, w.tokens().map);
  const float width = std::min(w.px(560), rect.width - w.px(48));
  const float height = w.px(frame.status.recent_projects.empty() ? 330 : 460);
  const Rect column{std::round(rect.center_x() - 0.5f * width), std::round(std::max(rect.y + w.px(24), rect.center_y() - 0.55f * height)), width, height};
  draw_mark(w, column.x + w.px(28), column.y + w.px(28));
  w.text_in({column.x, column.y + w.px(72), width, w.px(26)}, "Bring in two or more surveys of the same forest", TextRole::title, Tone::text);
  ImGui::SetCursorScreenPos({column.x, column.y + w.px(104)});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  w.text("Drop stem lists or frame folders anywhere in this window. Stemwise finds how they lie on each other without GNSS, plot centres "
         "or a first guess, shows which stem is which and how it grew.",
         TextRole::body, Tone::secondary);
  ImGui::PopTextWrapPos();
  draw_actions(w, frame, column);
  draw_recent(w, frame, column);
}

void EmptyState::draw_actions(Widgets& w, Frame& frame, const Rect& column) {
  const float y = column.y + w.px(172);
  const float gap = w.px(12);
  const float third = (column.width - 2 * gap) / 3.0f;
  w.action_button_in({column.x, y, third, w.px(36)}, "empty/add", ActionId::file_add, frame.available, frame.requests, {.primary = true});
  w.action_button_in({column.x + third + gap, y, third, w.px(36)}, "empty/open", ActionId::file_open, frame.available, frame.requests);
  w.action_button_in({column.x + 2 * (third + gap), y, third, w.px(36)}, "empty/demo", ActionId::file_demo, frame.available, frame.requests);
  const char* lines[] = {"Reads: frame folders (trajectory.txt with TreeManagerState files), CSV and other stem tables,",
                         "GeoPackage and Shapefile points, Stemwise projects. Units and columns are recognised by their names."};
  for (int i = 0; i < 2; ++i) {
    w.text_in({column.x, y + w.px(56) + w.px(18) * static_cast<float>(i), column.width, w.px(18)}, lines[i], TextRole::caption, Tone::secondary);
  }
}

void EmptyState::draw_recent(Widgets& w, Frame& frame, const Rect& column) {
  if (frame.status.recent_projects.empty()) return;
  float y = column.y + w.px(284);
  w.text_in({column.x, y, column.width, w.px(20)}, "Recent projects", TextRole::strong, Tone::text);
  y += w.px(26);
  std::size_t shown = 0;
  for (const std::string& path : frame.status.recent_projects) {
    if (++shown > 5) break;
    const Rect row{column.x - w.px(8), y, column.width + w.px(16), w.px(28)};
    if (w.area("empty/recent/" + std::to_string(shown), row, path)) frame.requests.emit(request::OpenProject{path});
    const std::filesystem::path file(path);
    w.text_in({row.x + w.px(8), y, w.px(200), row.height}, file.filename().string(), TextRole::body, Tone::accent);
    w.text_in({row.x + w.px(216), y, row.width - w.px(224), row.height}, file.parent_path().string(), TextRole::table, Tone::secondary);
    y += row.height;
  }
}

}  // namespace stemwise::ui
