#include "ui/panels/status_bar.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/text/format.hpp"

namespace stemwise::ui {

void StatusBar::draw(Widgets& w, Frame& frame, const Rect& rect) {
  w.fill(rect, w.tokens().background);
  w.hairline(rect.x, rect.y, rect.right(), rect.y + 1);
  float right = draw_notices(w, frame, rect);
  right = draw_job(w, frame, rect, right);
  draw_coordinates(w, frame, rect, right);
}

float StatusBar::draw_notices(Widgets& w, Frame& frame, const Rect& rect) {
  const auto count = static_cast<std::int64_t>(frame.status.notices.size());
  const std::string label = count == 0 ? "No notices" : plural(count, "notice", "notices");
  const float width = w.text_width(label, TextRole::table) + w.px(16);
  const Rect area{rect.right() - w.px(8) - width, rect.y + w.px(3), width, rect.height - w.px(6)};
  if (w.area("status/notices", area, label)) {
    frame.view.tab = BottomTab::jobs;
    frame.view.panels.show_bottom = true;
  }
  if (ImGui::IsItemHovered()) w.tooltip("Shows jobs and notices");
  w.text_in(area, label, TextRole::table, count == 0 ? Tone::secondary : Tone::text, Align::center);
  return area.x - w.px(12);
}

float StatusBar::draw_job(Widgets& w, Frame& frame, const Rect& rect, float right) {
  const JobView* job = frame.status.running();
  if (job == nullptr) return right;
  const float cancel_width = w.px(56);
  const Rect cancel{right - cancel_width, rect.y + w.px(2), cancel_width, rect.height - w.px(4)};
  if (w.button_in(cancel, "status/cancel", "Cancel", {.quiet = true, .tooltip = "Stops the job; nothing changes  (Shift+Esc)"})) {
    frame.requests.emit(request::CancelJob{job->id});
  }
  std::string text = job->stage.empty() ? job->title : job->stage;
  if (job->left_s) text += ", " + duration_text(*job->left_s) + " left";
  const float text_width = std::min(w.text_width(text, TextRole::table) + w.px(4), w.px(300));
  const Rect label{cancel.x - w.px(12) - text_width, rect.y, text_width, rect.height};
  w.text_in(label, text, TextRole::table, Tone::secondary);
  const Rect bar{label.x - w.px(10) - w.px(170), rect.center_y() - w.px(3.5f), w.px(170), w.px(7)};
  w.progress_bar(bar, job->fraction);
  w.record("status/job", label, text);
  return bar.x - w.px(16);
}

void StatusBar::draw_coordinates(Widgets& w, const Frame& frame, const Rect& rect, float right) {
  float x = rect.x + w.px(16);
  const WindowStatus& s = frame.status;
  int index = 0;
  for (const std::string* text : {&s.cursor_local, &s.cursor_projected, &s.cursor_geographic}) {
    const char* names[] = {"status/local", "status/projected", "status/geographic"};
    const float width = std::max(w.text_width(*text, TextRole::table), index == 0 ? w.px(150) : 0.0f);
    if (!text->empty() && x + width <= right) {
      const Rect cell{x, rect.y, width, rect.height};
      w.text_in(cell, *text, TextRole::table, Tone::secondary);
      w.record(names[index], cell, *text);
      x += width + w.px(24);
    }
    ++index;
  }
}

}  // namespace stemwise::ui
