#include "ui/panels/growth_tab.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/panels/chart_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

struct Shown {
  Chart chart;
  const char* path;
};
// The most telling first; as many as there is room for.
constexpr Shown charts[] = {{Chart::growth_distribution, "growth/distribution"}, {Chart::dbh_classes, "growth/classes"},
                            {Chart::growth_against_dbh, "growth/against_dbh"}, {Chart::residuals, "growth/residuals"}};
constexpr float narrowest_chart = 290.0f;

}  // namespace

void GrowthTab::draw(Widgets& w, Frame& frame) {
  if (frame.tables().growth.empty()) {
    w.gap(8);
    w.text("Growth appears here when two surveys or more are aligned.", TextRole::body, Tone::secondary);
    return;
  }
  const float width = w.available_width();
  const float figures = std::min(w.px(262), width * 0.34f);
  const float height = ImGui::GetContentRegionAvail().y - w.px(6);
  const Rect area = w.next_rect(width, height);
  ImGui::BeginChild("figures", {figures, height});
  draw_figures(w, frame);
  ImGui::EndChild();
  const float gap = w.px(12);
  const float room = width - figures - gap;
  const int shown = std::clamp(static_cast<int>(room / w.px(narrowest_chart)), 1, 4);
  const float each = (room - gap * static_cast<float>(shown - 1)) / static_cast<float>(shown);
  for (int i = 0; i < shown; ++i) {
    draw_chart(w, frame, charts[i].chart, {area.x + figures + gap + (each + gap) * static_cast<float>(i), area.y, each, height}, charts[i].path);
  }
}

void GrowthTab::draw_figures(Widgets& w, const Frame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(8), 0});
  int index = 0;
  for (const GrowthRow& g : frame.tables().growth) {
    const std::string path = "growth/" + std::to_string(index++);
    w.text(survey_label(frame.state(), g.from) + " to " + survey_label(frame.state(), g.to), TextRole::strong);
    w.fact(path + "/n", "Trees measured in both", count_text(g.n));
    w.fact(path + "/median", "Median DBH change", change_text(g.median_change_m) + " cm", "Half of the trees changed less, half more.");
    w.fact(path + "/ci", "95 % interval", change_text(g.ci95_m[0]) + " to " + change_text(g.ci95_m[1]) + " cm", "Of the true median: errors of measurement, which draw it towards the mean, are allowed for.");
    w.fact(path + "/band", "20–80 % band", change_text(g.p20_p80_m[0]) + " to " + change_text(g.p20_p80_m[1]) + " cm");
    w.fact(path + "/error", "DBH error", fixed(g.dbh_error_m * 100.0, 1) + " cm", "One measurement's error, robustly estimated from the matched stems.");
    if (g.years) w.fact(path + "/years", "Years between", fixed(*g.years, 2));
    w.gap(10);
  }
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
