#include "ui/panels/toasts.hpp"

#include <imgui.h>

#include <algorithm>

namespace stemwise::ui {
namespace {

constexpr double note_seconds = 8.0;
constexpr double error_seconds = 60.0;
constexpr int most = 3;

void draw_toast(Widgets& w, Frame& frame, const Notice& notice, float right, float& bottom) {
  const std::string id = "toast" + std::to_string(notice.id);
  const float width = w.px(380);
  ImGui::SetNextWindowPos({right, bottom}, ImGuiCond_Always, {1.0f, 1.0f});
  ImGui::SetNextWindowSize({width, 0});
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                 ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin(id.c_str(), nullptr, flags)) {
    const float title_width = w.available_width() - w.px(52);
    const float lines_high = w.wrapped_height(notice.title, TextRole::strong, title_width);
    const Rect head = w.next_rect(w.available_width(), std::max(w.px(22), lines_high + w.px(4)));
    const Tone tone = notice.severity == Severity::error ? Tone::error : notice.severity == Severity::warning ? Tone::warning : Tone::accent;
    w.text_in({head.x, head.y, w.px(18), w.px(22)}, notice.severity == Severity::note ? icon::info : icon::warning, TextRole::body, tone);
    w.wrapped_in({head.x + w.px(24), head.y + w.px(3), title_width, lines_high}, notice.title, TextRole::strong, Tone::text);
    w.record("toast/" + std::to_string(notice.id), head, notice.title);
    if (w.button_in({head.right() - w.px(22), head.y, w.px(22), w.px(22)}, "toast/dismiss/" + std::to_string(notice.id), "", {.quiet = true, .icon = icon::cross})) {
      frame.requests.emit(request::DismissNotice{notice.id});
    }
    ImGui::SetCursorScreenPos({head.x, head.bottom() + w.px(4)});
    // A mere note does not cover the map: the rest of its details is in the table below.
    const std::size_t lines = std::min<std::size_t>(notice.details.size(), notice.severity == Severity::note ? 1 : 3);
    for (std::size_t i = 0; i < lines; ++i) w.paragraph(to_string(notice.details[i]), TextRole::table, Tone::secondary);
    draw_choices(w, frame, notice, "toast");
    if (notice.details.size() > lines) {
      const std::string more = std::to_string(notice.details.size() - lines) + " more under Jobs";
      if (w.button("toast/more/" + std::to_string(notice.id), more, {.quiet = true})) {
        frame.view.tab = BottomTab::jobs;
        frame.view.panels.show_bottom = true;
      }
    }
    bottom -= ImGui::GetWindowHeight() + w.px(8);
  }
  ImGui::End();
}

}  // namespace

void draw_choices(Widgets& w, Frame& frame, const Notice& notice, const std::string& path) {
  for (std::size_t i = 0; i < notice.choices.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, w.px(6));
    const std::string button = path + "/choice/" + std::to_string(notice.id) + "/" + notice.choices[i];
    if (w.button(button, notice.choices[i])) frame.requests.emit(request::NoticeChoice{notice.id, i});
  }
}

void draw_toasts(Widgets& w, Frame& frame, const Rect& area) {
  float bottom = area.bottom() - w.px(56);  // above the map's scale bar
  int shown = 0;
  // Errors and questions before notes, and none over the tool bar.
  for (const bool urgent : {true, false}) {
    for (const Notice& notice : frame.status.notices) {
      const bool is_urgent = notice.severity == Severity::error || !notice.choices.empty();
      const double seconds = is_urgent ? error_seconds : note_seconds;
      const bool has_room = shown == 0 || bottom - area.y > w.px(urgent ? 210 : 170);
      if (is_urgent != urgent || notice.age_s > seconds || shown >= most || !has_room) continue;
      ++shown;
      draw_toast(w, frame, notice, area.right() - w.px(12), bottom);
    }
  }
}

}  // namespace stemwise::ui
