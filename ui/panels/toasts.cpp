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
    const Rect head = w.next_rect(w.available_width(), w.px(22));
    const Tone tone = notice.severity == Severity::error ? Tone::error : notice.severity == Severity::warning ? Tone::warning : Tone::accent;
    w.text_in({head.x, head.y, w.px(18), head.height}, notice.severity == Severity::note ? icon::info : icon::warning, TextRole::body, tone);
    w.text_in({head.x + w.px(24), head.y, head.width - w.px(52), head.height}, notice.title, TextRole::strong, Tone::text);
    w.record("toast/" + std::to_string(notice.id), head, notice.title);
    if (w.button_in({head.right() - w.px(22), head.y, w.px(22), w.px(22)}, "toast/dismiss/" + std::to_string(notice.id), "", {.quiet = true, .icon = icon::cross})) {
      frame.requests.emit(request::DismissNotice{notice.id});
    }
    // A mere note does not cover the map: its details are in the table below.
    const std::size_t lines = notice.severity == Severity::note ? 0 : std::min<std::size_t>(notice.details.size(), 2);
    for (std::size_t i = 0; i < lines; ++i) w.paragraph(to_string(notice.details[i]), TextRole::table, Tone::secondary);
    if (notice.details.size() > lines) w.text("more under Jobs and notices", TextRole::table, Tone::secondary);
    bottom -= ImGui::GetWindowHeight() + w.px(8);
  }
  ImGui::End();
}

}  // namespace

void draw_toasts(Widgets& w, Frame& frame, const Rect& area) {
  float bottom = area.bottom() - w.px(12);
  int shown = 0;
  for (const Notice& notice : frame.status.notices) {
    const double seconds = notice.severity == Severity::error ? error_seconds : note_seconds;
    if (notice.age_s > seconds || ++shown > most) continue;
    draw_toast(w, frame, notice, area.right() - w.px(12), bottom);
  }
}

}  // namespace stemwise::ui
