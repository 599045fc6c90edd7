#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/panels/inspector.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

struct Point {
  double when = 0.0;   ///< days, or the survey's place where there is no date
  double dbh_cm = 0.0;
  double error_cm = 0.0;
  std::string label;
};

std::vector<Point> points_of(const Frame& frame, TreeId tree) {
  std::vector<Point> points;
  const std::vector<const ObservationRow*> rows = frame.derived.sightings(tree);
  const bool dated = std::all_of(rows.begin(), rows.end(), [&](const ObservationRow* r) {
    const Inventory* inventory = frame.state().find(r->stem.inventory);
    return inventory != nullptr && inventory->date;
  });
  double place = 0.0;
  for (const ObservationRow* r : rows) {
    place += 1.0;
    if (!r->dbh_m) continue;
    const double when = dated ? frame.state().find(r->stem.inventory)->date->days : place;
    points.push_back({when, *r->dbh_m * 100.0, r->dbh_error_m.value_or(0.0) * 100.0, survey_label(frame.state(), r->stem.inventory)});
  }
  return points;
}

/// 1, 2 or 5 times a power of ten, so that about four steps fill the range.
double tick_step(double range) {
  const double raw = std::max(range, 1e-6) / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (raw <= m * power) return m * power;
  }
  return 10.0 * power;
}

struct Axis {
  double low = 0.0, high = 1.0, step = 1.0;
};

Axis axis_of(const std::vector<Point>& points) {
  double low = 1e9, high = -1e9;
  for (const Point& p : points) {
    low = std::min(low, p.dbh_cm - p.error_cm);
    high = std::max(high, p.dbh_cm + p.error_cm);
  }
  const double middle = 0.5 * (low + high);
  const double half = std::max(0.5 * (high - low) * 1.15, 1.0);
  const double step = tick_step(2.0 * half);
  return {std::floor((middle - half) / step) * step, std::ceil((middle + half) / step) * step, step};
}

}  // namespace

void draw_dbh_chart(Widgets& w, const Frame& frame, TreeId tree, float height_px) {
  const std::vector<Point> points = points_of(frame, tree);
  if (points.empty()) {
    w.paragraph("No DBH was measured for this tree.", TextRole::table, Tone::secondary);
    return;
  }
  const Rect box = w.next_rect(w.available_width(), height_px);
  ImGui::Dummy({box.width, box.height});
  w.record("review/chart", box, std::to_string(points.size()) + " points");
  const Rect plot{box.x + w.px(34), box.y + w.px(6), box.width - w.px(46), box.height - w.px(30)};
  const Axis y = axis_of(points);
  const double t0 = points.front().when, t1 = points.back().when;
  const auto at = [&](double when, double dbh) {
    const double u = t1 > t0 ? 0.06 + 0.88 * (when - t0) / (t1 - t0) : 0.5;
    const double v = (dbh - y.low) / (y.high - y.low);
    return ImVec2(plot.x + plot.width * static_cast<float>(u), plot.bottom() - plot.height * static_cast<float>(v));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (double tick = y.low; tick <= y.high + 0.01 * y.step; tick += y.step) {
    const float ty = std::round(at(t0, tick).y);
    w.fill({plot.x, ty, plot.width, 1}, w.tokens().grid);
    w.text_in({box.x, ty - w.px(8), w.px(26), w.px(16)}, fixed(tick, y.step < 1.0 ? 1 : 0), TextRole::caption, Tone::secondary, Align::right);
  }
  const auto ink = w.tokens().accent.packed();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    draw->AddLine(at(points[i].when, points[i].dbh_cm), at(points[i + 1].when, points[i + 1].dbh_cm), ink, w.px(2));
  }
  for (const Point& p : points) {
    const ImVec2 c = at(p.when, p.dbh_cm);
    draw->AddLine(at(p.when, p.dbh_cm - p.error_cm), at(p.when, p.dbh_cm + p.error_cm), ink, w.px(1.5f));
    draw->AddCircleFilled(c, w.px(4.5f), w.tokens().panel.packed(), 24);
    draw->AddCircle(c, w.px(4.5f), ink, 24, w.px(2));
    const float half = 0.5f * w.text_width(p.label, TextRole::caption) + 1;
    const float lx = std::clamp(c.x, box.x + half, box.right() - half);
    w.text_in({lx - half, box.bottom() - w.px(20), 2 * half, w.px(16)}, p.label, TextRole::caption, Tone::secondary, Align::center);
    const ImVec2 mouse = ImGui::GetMousePos();
    if (ImGui::IsWindowHovered() && std::hypot(mouse.x - c.x, mouse.y - c.y) < w.px(10)) {
      w.tooltip(p.label + ": " + fixed(p.dbh_cm, 1) + " ± " + fixed(p.error_cm, 1) + " cm");
    }
  }
}

}  // namespace stemwise::ui
