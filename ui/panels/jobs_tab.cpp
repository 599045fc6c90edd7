#include "ui/panels/jobs_tab.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/toasts.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

Tone tone_of(Severity severity) {
  return severity == Severity::error ? Tone::error : severity == Severity::warning ? Tone::warning : Tone::secondary;
}

std::string state_words(const JobView& job) {
  switch (job.state) {
    case JobView::State::waiting: return "waiting";
    case JobView::State::running: return job.stage + (job.left_s ? ", " + duration_text(*job.left_s) + " left" : "");
    case JobView::State::done: return job.outcome.empty() ? "done in " + duration_text(job.elapsed_s) : job.outcome;
    case JobView::State::failed: return job.outcome.empty() ? "failed" : job.outcome;
    case JobView::State::cancelled: return "cancelled; nothing was changed";
  }
  return "";
}

}  // namespace

void JobsTab::draw(Widgets& w, Frame& frame) {
  const float half = 0.5f * w.available_width() - w.px(8);
  ImGui::BeginChild("jobs", {half, 0});
  if (frame.status.jobs.empty()) w.text("No job has run yet.", TextRole::body, Tone::secondary);
  for (const JobView& job : frame.status.jobs) draw_job(w, frame, job);
  ImGui::EndChild();
  ImGui::SameLine(0, w.px(16));
  ImGui::BeginChild("notices", {0, 0});
  if (frame.status.notices.empty()) {
    w.text("No notices.", TextRole::body, Tone::secondary);
  } else if (w.button("notices/clear", "Clear all", {.quiet = true})) {
    frame.requests.emit(request::DismissNotices{});
  }
  for (const Notice& notice : frame.status.notices) draw_notice(w, frame, notice);
  ImGui::EndChild();
}

void JobsTab::draw_job(Widgets& w, Frame& frame, const JobView& job) {
  const bool running = job.state == JobView::State::running;
  const bool failed = job.state == JobView::State::failed;
  const float width = w.available_width() - w.px(running ? 200 : 8);
  const float lines_high = std::max(w.px(18), w.wrapped_height(state_words(job), TextRole::table, width));
  const Rect row = w.next_rect(w.available_width(), w.px(26) + lines_high);
  ImGui::Dummy({row.width, row.height});
  const Rect words{row.x, row.y, width, w.px(20)};
  w.text_in(words, job.title, TextRole::strong, Tone::text);
  w.wrapped_in({row.x, row.y + w.px(21), words.width, lines_high}, state_words(job), TextRole::table, failed ? Tone::error : Tone::secondary);
  w.record("jobs/" + std::to_string(job.id), row, state_words(job));
  if (!running) return;
  w.progress_bar({row.right() - w.px(184), row.y + w.px(17), w.px(110), w.px(7)}, job.fraction);
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  if (w.button_in({row.right() - w.px(66), row.y + w.px(7), w.px(62), w.px(26)}, "jobs/cancel/" + std::to_string(job.id), "Cancel", {.quiet = true})) {
    frame.requests.emit(request::CancelJob{job.id});
  }
  ImGui::SetCursorScreenPos(cursor);
}

void JobsTab::draw_notice(Widgets& w, Frame& frame, const Notice& notice) {
  const float title_width = w.available_width() - w.px(56);
  const float lines_high = w.wrapped_height(notice.title, TextRole::strong, title_width);
  const Rect row = w.next_rect(w.available_width(), std::max(w.px(24), lines_high + w.px(6)));
  ImGui::Dummy({row.width, row.height});
  const char* mark = notice.severity == Severity::note ? icon::info : icon::warning;
  w.text_in({row.x, row.y, w.px(18), w.px(24)}, mark, TextRole::table, tone_of(notice.severity));
  w.wrapped_in({row.x + w.px(22), row.y + w.px(4), title_width, lines_high}, notice.title, TextRole::strong, Tone::text);
  w.record("notices/" + std::to_string(notice.id), row, notice.title);
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  if (w.button_in({row.right() - w.px(26), row.y, w.px(24), w.px(24)}, "notices/dismiss/" + std::to_string(notice.id), "", {.quiet = true, .icon = icon::cross, .tooltip = "Put this notice away"})) {
    frame.requests.emit(request::DismissNotice{notice.id});
  }
  ImGui::SetCursorScreenPos(cursor);
  ImGui::Indent(w.px(22));
  std::size_t shown = 0;
  for (const Issue& issue : notice.details) {
    if (++shown > 200) break;
    w.paragraph(to_string(issue), TextRole::table, Tone::secondary);
  }
  draw_choices(w, frame, notice, "notices");
  if (notice.details.size() > 200) w.text("and " + count_text(static_cast<std::int64_t>(notice.details.size()) - 200) + " more", TextRole::table, Tone::secondary);
  ImGui::Unindent(w.px(22));
}

}  // namespace stemwise::ui
