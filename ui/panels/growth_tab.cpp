#include "ui/panels/growth_tab.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/chart_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

// The most telling first.
constexpr Chart charts[] = {Chart::growth_distribution, Chart::dbh_classes, Chart::growth_against_dbh, Chart::residuals, Chart::residual_rose};
constexpr std::size_t count = std::size(charts);
constexpr float narrowest_chart = 300.0f;

std::size_t shown_step(const Frame& frame) { return std::min(frame.view.growth_step, frame.tables().growth.size() - 1); }

}  // namespace

void GrowthTab::draw(Widgets& w, Frame& frame) {
  if (frame.tables().growth.empty()) {
    w.gap(8);
    w.text("Growth appears here when two surveys or more are aligned.", TextRole::body, Tone::secondary);
    return;
  }
  const float width = w.available_width();
  const float figures = width < w.px(520) ? 0.0f : std::min(w.px(262), width * 0.34f);
  const float height = ImGui::GetContentRegionAvail().y - w.px(6);
  const Rect area = w.next_rect(width, height);
  if (figures > 0.0f) {  // with large text in a small window the chart alone
    ImGui::BeginChild("figures", {figures, height});
    draw_figures(w, frame);
    ImGui::EndChild();
  }
  const float gap = figures > 0.0f ? w.px(12) : 0.0f;
  draw_charts(w, frame, {area.x + figures + gap, area.y, width - figures - gap, height});
}

void GrowthTab::draw_charts(Widgets& w, Frame& frame, const Rect& area) {
  const float gap = w.px(12), head = w.px(28);
  const auto shown = static_cast<std::size_t>(std::clamp(static_cast<int>((area.width + gap) / (w.px(narrowest_chart) + gap)), 1, static_cast<int>(count)));
  const float each = (area.width - gap * static_cast<float>(shown - 1)) / static_cast<float>(shown);
  const auto first = static_cast<std::size_t>(std::find(std::begin(charts), std::end(charts), frame.view.chart) - std::begin(charts)) % count;
  std::vector<std::string> names;
  for (const Chart chart : charts) names.emplace_back(chart_label(chart));
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t at = (first + i) % count;
    const float x = area.x + (each + gap) * static_cast<float>(i);
    const std::string path = std::string("growth/") + chart_word(charts[at]);
    int chosen = static_cast<int>(at);
    ImGui::SetCursorScreenPos({x, area.y});
    if (w.combo("growth/choose/" + std::to_string(i), names, chosen, std::min(w.px(216), each - w.px(78)))) frame.view.chart = charts[(static_cast<std::size_t>(chosen) + count - i) % count];
    if (w.button_in({x + each - w.px(72), area.y, w.px(72), head}, path + "/save", "Save…", {.tooltip = "This chart as a picture (.png) or drawing (.svg)"})) {
      frame.view.saved_chart = charts[at];
      frame.view.dialog = Dialog::chart_path;
    }
    draw_chart(w, frame, charts[at], {x, area.y + head, each, area.height - head}, path);
  }
}

void GrowthTab::draw_figures(Widgets& w, Frame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(8), 0});
  for (std::size_t i = 0; i < frame.tables().growth.size(); ++i) draw_pair(w, frame, i);
  ImGui::PopStyleVar();
}

/// A click on its head: the charts are of this pair.
void GrowthTab::draw_pair(Widgets& w, Frame& frame, std::size_t index) {
  const GrowthRow& g = frame.tables().growth[index];
  const std::string path = "growth/" + std::to_string(index);
  const bool on = shown_step(frame) == index;
  const Rect head = w.next_rect(w.available_width() - w.px(12), w.px(24));
  const std::string words = survey_label(frame.state(), g.from) + " to " + survey_label(frame.state(), g.to);
  if (w.area(path, head, on ? "shown" : "")) frame.view.growth_step = index;
  if (ImGui::IsItemHovered()) w.tooltip(on ? "The charts are of these two surveys" : "Click: the charts of these two surveys");
  w.text_in(head, words, TextRole::strong, on ? Tone::accent : Tone::text);
  w.fact(path + "/n", "Trees measured in both", count_text(g.n));
  w.fact(path + "/median", "Median DBH change", change_text(g.median_change_m) + " cm", "Half of the trees changed less, half more.");
  w.fact(path + "/ci", "95 % interval", change_text(g.ci95_m[0]) + " to " + change_text(g.ci95_m[1]) + " cm", "Of the true median: errors of measurement, which draw it towards the mean, are allowed for.");
  w.fact(path + "/band", "20–80 % band", change_text(g.p20_p80_m[0]) + " to " + change_text(g.p20_p80_m[1]) + " cm", "One tree in five changed less than its lower end, one in five more than its upper one.");
  w.fact(path + "/error", "DBH error", fixed(g.dbh_error_m * 100.0, 1) + " cm", "One measurement's error, robustly estimated from the matched stems.");
  if (g.years) w.fact(path + "/years", "Years between", fixed(*g.years, 2));
  w.gap(10);
}

}  // namespace stemwise::ui
