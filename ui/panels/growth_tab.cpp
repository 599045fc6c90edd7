#include "ui/panels/growth_tab.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

constexpr double class_step_cm = 5.0;
constexpr double change_step_cm = 0.5;
constexpr double change_limit_cm = 8.0;

}  // namespace

void GrowthTab::collect(const Frame& frame) {
  revision_ = frame.derived.revision;
  const Tables& t = frame.tables();
  classes_ = {};
  change_ = {};
  classes_.step = class_step_cm;
  for (const InventoryId id : t.inventories) {
    std::vector<int> counts;
    for (const ObservationRow& row : t.observations) {
      if (row.stem.inventory != id || !row.dbh_m) continue;
      const auto k = static_cast<std::size_t>(std::clamp(*row.dbh_m * 100.0 / class_step_cm, 0.0, 39.0));
      if (counts.size() <= k) counts.resize(k + 1);
      ++counts[k];
    }
    classes_.series.push_back(std::move(counts));
    classes_.colors.push_back(inventory_color(frame.state(), id));
    classes_.labels.push_back(survey_label(frame.state(), id));
  }
  if (t.growth.empty()) return;
  change_.low = -change_limit_cm;
  change_.step = change_step_cm;
  change_.colors = {hex(0x2A7A4C)};
  const GrowthRow& last = t.growth.back();
  std::vector<int> counts(static_cast<std::size_t>(2.0 * change_limit_cm / change_step_cm));
  for (const MatchRow& m : t.matches) {
    if (m.state == MatchState::rejected || !m.change_m || m.a.inventory != last.from || m.b.inventory != last.to) continue;
    const double place = (*m.change_m * 100.0 + change_limit_cm) / change_step_cm;
    if (place >= 0.0 && place < static_cast<double>(counts.size())) ++counts[static_cast<std::size_t>(place)];
  }
  change_.series.push_back(std::move(counts));
  change_.labels = {"DBH change"};
}

void GrowthTab::draw(Widgets& w, Frame& frame) {
  if (frame.tables().growth.empty()) {
    w.gap(8);
    w.text("Growth appears here when two surveys or more are aligned.", TextRole::body, Tone::secondary);
    return;
  }
  if (revision_ != frame.derived.revision) collect(frame);
  const float width = w.available_width();
  const float figures = std::min(w.px(270), width * 0.34f);
  const Rect area = w.next_rect(width, ImGui::GetContentRegionAvail().y - w.px(6));
  ImGui::BeginChild("figures", {figures, area.height});
  draw_figures(w, frame);
  ImGui::EndChild();
  const float gap = w.px(24);
  const float each = 0.5f * (width - figures - 2 * gap);
  draw_bars(w, {area.x + figures + gap, area.y, each, area.height}, classes_, "DBH classes of 5 cm", "cm", nullptr);
  const GrowthRow& last = frame.tables().growth.back();
  const std::string title = "DBH change, " + survey_label(frame.state(), last.from) + " to " + survey_label(frame.state(), last.to);
  draw_bars(w, {area.x + figures + 2 * gap + each, area.y, each, area.height}, change_, title, "cm", &last);
}

void GrowthTab::draw_figures(Widgets& w, const Frame& frame) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(8), 0});
  int index = 0;
  for (const GrowthRow& g : frame.tables().growth) {
    const std::string path = "growth/" + std::to_string(index++);
    w.text(survey_label(frame.state(), g.from) + " to " + survey_label(frame.state(), g.to), TextRole::strong);
    w.fact(path + "/n", "Trees measured in both", count_text(g.n));
    w.fact(path + "/median", "Median DBH change", change_text(g.median_change_m) + " cm", "Half of the trees changed less, half more.");
    w.fact(path + "/ci", "95 % interval", change_text(g.ci95_m[0]) + " to " + change_text(g.ci95_m[1]) + " cm", "Of the median, by order statistics.");
    w.fact(path + "/band", "20–80 % band", change_text(g.p20_p80_m[0]) + " to " + change_text(g.p20_p80_m[1]) + " cm");
    w.fact(path + "/error", "DBH error", fixed(g.dbh_error_m * 100.0, 1) + " cm", "One measurement's error, robustly estimated from the matched stems.");
    if (g.years) w.fact(path + "/years", "Years between", fixed(*g.years, 2));
    w.gap(10);
  }
  ImGui::PopStyleVar();
}

void GrowthTab::draw_bars(Widgets& w, const Rect& rect, const Bars& bars, const std::string& title, const std::string& unit, const GrowthRow* band) {
  w.text_in({rect.x, rect.y, rect.width, w.px(20)}, title, TextRole::strong, Tone::text);
  const Rect plot{rect.x + w.px(34), rect.y + w.px(28), rect.width - w.px(38), rect.height - w.px(54)};
  std::size_t classes = 1;
  int most = 1;
  for (const auto& series : bars.series) {
    classes = std::max(classes, series.size());
    for (const int n : series) most = std::max(most, n);
  }
  const auto x_of = [&](double value) { return plot.x + plot.width * static_cast<float>((value - bars.low) / (bars.step * static_cast<double>(classes))); };
  if (band != nullptr) {
    const float x0 = x_of(band->p20_p80_m[0] * 100.0), x1 = x_of(band->p20_p80_m[1] * 100.0);
    w.fill({x0, plot.y, std::max(x1 - x0, 1.0f), plot.height}, w.tokens().accent_soft);
  }
  for (int k = 0; k <= 2; ++k) {
    const float y = std::round(plot.bottom() - plot.height * 0.5f * static_cast<float>(k));
    w.fill({plot.x, y, plot.width, 1}, w.tokens().grid);
    w.text_in({rect.x, y - w.px(8), w.px(28), w.px(16)}, count_text(most * k / 2), TextRole::caption, Tone::secondary, Align::right);
  }
  const ImVec2 mouse = ImGui::GetMousePos();
  const float slot = plot.width / static_cast<float>(classes);
  const float bar = std::max(1.0f, (slot - w.px(2)) / static_cast<float>(std::max<std::size_t>(bars.series.size(), 1)));
  for (std::size_t s = 0; s < bars.series.size(); ++s) {
    for (std::size_t k = 0; k < bars.series[s].size(); ++k) {
      const float height = plot.height * static_cast<float>(bars.series[s][k]) / static_cast<float>(most);
      const Rect r{plot.x + slot * static_cast<float>(k) + w.px(1) + bar * static_cast<float>(s), plot.bottom() - height, bar, height};
      w.fill(r, bars.colors[s]);
      if (!ImGui::IsWindowHovered() || !Rect{r.x, plot.y, r.width, plot.height}.contains(mouse.x, mouse.y)) continue;
      const double low = bars.low + bars.step * static_cast<double>(k);
      w.tooltip(bars.labels[s] + ", " + fixed(low, 1) + " to " + fixed(low + bars.step, 1) + " " + unit + ": " + plural(bars.series[s][k], "tree", "trees"));
    }
  }
  const std::size_t every = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(static_cast<float>(classes) / 6.0f)));
  for (std::size_t k = 0; k <= classes; k += every) {
    const double value = bars.low + bars.step * static_cast<double>(k);
    w.text_in({x_of(value) - w.px(24), plot.bottom() + w.px(4), w.px(48), w.px(16)}, fixed(value, 0) + (k == 0 ? " " + unit : ""), TextRole::caption, Tone::secondary, Align::center);
  }
}

}  // namespace stemwise::ui
