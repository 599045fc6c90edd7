#include "ui/panels/bottom_panel.hpp"

#include <imgui.h>

#include <array>
#include <numeric>

#include "ui/text/format.hpp"

namespace stemwise::ui {

void BottomPanel::draw(Widgets& w, Frame& frame, const Rect& rect) {
  draw_tabs(w, frame, rect);
  ImGui::SetCursorScreenPos({rect.x + w.px(8), rect.y + w.px(40)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {w.px(8), 0});
  ImGui::BeginChild("bottom_content", {rect.width - w.px(16), rect.height - w.px(42)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  switch (frame.view.tab) {
    case BottomTab::queue: queue_.draw(w, frame); break;
    case BottomTab::matches: matches_.draw(w, frame); break;
    case BottomTab::growth: growth_.draw(w, frame); break;
    case BottomTab::conflicts: conflicts_.draw(w, frame); break;
    case BottomTab::log: log_.draw(w, frame); break;
    case BottomTab::jobs: jobs_.draw(w, frame); break;
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

/// With how much each holds; where there is no room for that, the words alone, closer together.
void BottomPanel::draw_tabs(Widgets& w, Frame& frame, const Rect& rect) {
  const auto count = [](std::size_t n) { return n == 0 ? std::string() : count_text(static_cast<std::int64_t>(n)); };
  const auto open = frame.tables().queue.size() - static_cast<std::size_t>(frame.derived.decided);
  struct Tab { BottomTab tab; const char* label; std::string count; };
  std::array<Tab, 6> tabs{{{BottomTab::queue, "Review queue", count(open)},
                           {BottomTab::matches, "Matches", count(frame.tables().matches.size())},
                           {BottomTab::growth, "Growth", ""},
                           {BottomTab::conflicts, "Conflicts", count(frame.derived.conflicts.size())},
                           {BottomTab::log, "Edit log", count(frame.state().edit_log.size())},
                           {BottomTab::jobs, "Jobs", count(frame.status.jobs.size())}}};
  const auto width_of = [&](const Tab& t, float gap) { return w.text_width(t.label, TextRole::strong) + (t.count.empty() ? 0.0f : w.text_width(t.count, TextRole::caption) + w.px(8)) + gap; };
  const auto total = [&](float gap) { return std::accumulate(tabs.begin(), tabs.end(), 0.0f, [&](float sum, const Tab& t) { return sum + width_of(t, gap); }); };
  float gap = w.px(24);
  const float room = rect.width - w.px(32);
  if (total(gap) - gap > room) {
    gap = w.px(14);
    for (Tab& t : tabs) t.count.clear();
  }
  float x = rect.x + w.px(16);
  for (const Tab& t : tabs) {
    draw_tab(w, frame, t.tab, t.label, t.count, x, rect.y + w.px(4));
    x += width_of(t, gap);
  }
}

void BottomPanel::draw_tab(Widgets& w, Frame& frame, BottomTab tab, const char* label, const std::string& count, float x, float y) {
  const bool active = frame.view.tab == tab;
  const float label_width = w.text_width(label, TextRole::strong);
  const float count_width = count.empty() ? 0.0f : w.text_width(count, TextRole::caption) + w.px(8);
  const Rect rect{x - w.px(6), y, label_width + count_width + w.px(12), w.px(30)};
  if (w.area(std::string("tabs/") + label, rect, count)) frame.view.tab = tab;
  w.text_in({x, y, label_width + 1, rect.height}, label, active ? TextRole::strong : TextRole::body, active ? Tone::accent : Tone::secondary);
  w.text_in({x + label_width + w.px(8), y, count_width, rect.height}, count, TextRole::caption, Tone::secondary);
  if (active) w.fill({x, rect.bottom(), label_width, w.px(2)}, w.tokens().accent);
}

}  // namespace stemwise::ui
