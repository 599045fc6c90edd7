#include "io/report/charts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/quantile.hpp"
#include "core/survey/fate.hpp"
#include "io/report/palette.hpp"

namespace stemwise {
namespace {

constexpr double chart_width = 660.0;

/// The plot's rectangle and its two scales.
struct Axes {
  double left = 56.0, right = chart_width - 16.0, top = 34.0, bottom = 224.0;
  double x_low = 0.0, x_high = 1.0, y_high = 1.0;
  double x(double value) const { return left + (value - x_low) / (x_high - x_low) * (right - left); }
  double y(double value) const { return bottom - value / y_high * (bottom - top); }
};

/// 1, 2 or 5 times a power of ten: about `wanted` steps over `span`.
double nice_step(double span, int wanted) {
  const double raw = std::max(span, 1e-12) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power * (1.0 + 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::string tick_text(double value, double step) {
  char text[32];
  const int decimals = step >= 1.0 - 1e-9 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < step * 1e-6 ? 0.0 : value);
  return text[0] == '-' ? "\u2212" + std::string(text + 1) : text;
}

void draw_count_axis(Drawing& drawing, const Axes& axes, const std::string& title) {
  const double step = std::max(1.0, nice_step(axes.y_high, 4));
  for (double value = 0.0; value <= axes.y_high * (1.0 + 1e-9); value += step) {
    drawing.items.push_back(DrawLine{{axes.left, axes.y(value)}, {axes.right, axes.y(value)}, value == 0.0 ? palette::secondary : palette::grid});
    drawing.items.push_back(DrawText{{axes.left - 8.0, axes.y(value) + 4.0}, tick_text(value, step), 10.5, palette::secondary, TextAnchor::end});
  }
  drawing.items.push_back(DrawText{{14.0, (axes.top + axes.bottom) / 2.0}, title, 10.5, palette::secondary, TextAnchor::middle, false, true});
}

void draw_value_axis(Drawing& drawing, const Axes& axes, const std::string& title) {
  const double step = nice_step(axes.x_high - axes.x_low, 9);
  for (double value = std::ceil(axes.x_low / step - 1e-9) * step; value <= axes.x_high + step * 1e-6; value += step) {
    drawing.items.push_back(DrawLine{{axes.x(value), axes.bottom}, {axes.x(value), axes.bottom + 4.0}, palette::secondary});
    drawing.items.push_back(DrawText{{axes.x(value), axes.bottom + 17.0}, tick_text(value, step), 10.5, palette::secondary, TextAnchor::middle});
  }
  drawing.items.push_back(DrawText{{(axes.left + axes.right) / 2.0, axes.bottom + 36.0}, title, 10.5, palette::secondary, TextAnchor::middle});
}

struct Histogram {
  double low_cm = 0.0, width_cm = 1.0;
  std::vector<int> counts;
};

/// Between the 0.5 and 99.5 percentiles (what lies beyond is counted in the outermost bars), bars on whole steps.
Histogram histogram_of(const std::vector<double>& ascending_m) {
  const double first = 100.0 * quantile_of_sorted(ascending_m, 0.005);
  const double last = 100.0 * quantile_of_sorted(ascending_m, 0.995);
  Histogram histogram;
  histogram.width_cm = std::max(0.1, nice_step(last - first, 30));
  histogram.low_cm = std::floor(first / histogram.width_cm - 1e-9) * histogram.width_cm;
  const auto bars = static_cast<std::size_t>(std::floor((last - histogram.low_cm) / histogram.width_cm + 1e-9)) + 1;
  histogram.counts.assign(bars, 0);
  for (const double change_m : ascending_m) {
    const double bar = std::floor((100.0 * change_m - histogram.low_cm) / histogram.width_cm + 1e-9);
    ++histogram.counts[static_cast<std::size_t>(std::clamp(bar, 0.0, static_cast<double>(bars - 1)))];
  }
  return histogram;
}

std::string change_text(double change_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f cm", std::abs(change_m) * 100.0);
  return (change_m <= -0.0005 ? "\u2212" : change_m >= 0.0005 ? "+" : "") + std::string(text);
}

void draw_marked(Drawing& drawing, const Axes& axes, const GrowthRow& row) {
  const double median = 100.0 * row.median_change_m;
  drawing.items.push_back(DrawLine{{axes.x(median), axes.top - 6.0}, {axes.x(median), axes.bottom}, palette::text, 1.5});
  drawing.items.push_back(DrawText{{axes.x(median), axes.top - 12.0}, "median " + change_text(row.median_change_m), 11.0, palette::text, TextAnchor::middle, true});
}

}  // namespace

Drawing draw_change_histogram(const ReportModel& model, const ReportGrowth& growth) {
  const Histogram histogram = histogram_of(growth.changes_m);
  Axes axes;
  axes.x_low = histogram.low_cm;
  axes.x_high = histogram.low_cm + histogram.width_cm * static_cast<double>(histogram.counts.size());
  axes.y_high = 1.05 * std::max(1, *std::max_element(histogram.counts.begin(), histogram.counts.end()));
  Drawing drawing{chart_width, 270.0, "Histogram of DBH change from " + model.surveys[growth.from].name + " to " + model.surveys[growth.to].name, {}};
  const double band_left = std::max(axes.left, axes.x(100.0 * growth.row.p20_p80_m[0]));
  const double band_right = std::min(axes.right, axes.x(100.0 * growth.row.p20_p80_m[1]));
  drawing.items.push_back(DrawRect{band_left, axes.top, std::max(0.0, band_right - band_left), axes.bottom - axes.top, palette::accent_soft});
  draw_count_axis(drawing, axes, "stems");
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double left = axes.x(histogram.low_cm + histogram.width_cm * static_cast<double>(i));
    const double width = axes.x(histogram.low_cm + histogram.width_cm) - axes.left;
    drawing.items.push_back(DrawRect{left + 0.5, axes.y(histogram.counts[i]), width - 1.0, axes.bottom - axes.y(histogram.counts[i]), palette::accent});
  }
  draw_value_axis(drawing, axes, "DBH change, cm");
  draw_marked(drawing, axes, growth.row);
  return drawing;
}

Drawing draw_dbh_classes(const ReportModel& model) {
  int most = 1;
  for (const ReportDbhClass& c : model.dbh_classes) most = std::max(most, *std::max_element(c.stems.begin(), c.stems.end()));
  Axes axes;
  axes.x_low = model.dbh_classes.front().low_cm;
  axes.x_high = model.dbh_classes.back().high_cm;
  axes.y_high = 1.05 * most;
  Drawing drawing{chart_width, 270.0, "Living stems per DBH class and survey", {}};
  draw_count_axis(drawing, axes, "living stems");
  const auto n = static_cast<double>(model.placed);
  for (const ReportDbhClass& c : model.dbh_classes) {
    const double left = axes.x(c.low_cm), slot = (axes.x(c.high_cm) - left) * 0.84 / n;
    for (std::size_t s = 0; s < model.placed; ++s) {
      const double top = axes.y(c.stems[s]);
      drawing.items.push_back(DrawRect{left + (axes.x(c.high_cm) - left) * 0.08 + slot * static_cast<double>(s), top, std::max(0.5, slot - 0.5), axes.bottom - top,
                                       palette::surveys[s % palette::surveys.size()]});
    }
  }
  draw_value_axis(drawing, axes, "DBH, cm");
  double x = axes.left;
  for (std::size_t s = 0; s < model.placed; ++s) {
    drawing.items.push_back(DrawRect{x, 9.0, 10.0, 10.0, palette::surveys[s % palette::surveys.size()]});
    drawing.items.push_back(DrawText{{x + 15.0, 18.0}, model.surveys[s].name, 11.0, palette::text});
    x += 40.0 + 6.6 * static_cast<double>(model.surveys[s].name.size());
  }
  return drawing;
}

namespace {

struct MapFrame {
  double scale = 1.0;  ///< px per m
  double left = 8.0;   ///< where low_m.x() lies: the trees stand in the middle
  Eigen::Vector2d low_m, high_m;
  DrawPoint at(const Eigen::Vector3d& p) const { return {left + (p.x() - low_m.x()) * scale, 8.0 + (high_m.y() - p.y()) * scale}; }
};

MapFrame map_frame_of(const std::vector<TreeRow>& trees) {
  MapFrame frame;
  frame.low_m.setConstant(std::numeric_limits<double>::max());
  frame.high_m = -frame.low_m;
  for (const TreeRow& tree : trees) {
    frame.low_m = frame.low_m.cwiseMin(tree.position_m.head<2>());
    frame.high_m = frame.high_m.cwiseMax(tree.position_m.head<2>());
  }
  const Eigen::Vector2d extent = (frame.high_m - frame.low_m).cwiseMax(1.0);
  frame.scale = std::min((chart_width - 16.0) / extent.x(), 440.0 / extent.y());
  frame.left = 0.5 * (chart_width - extent.x() * frame.scale);
  return frame;
}

double draw_fate_legend(Drawing& drawing, const ReportModel& model, double y) {
  double x = 8.0;
  for (std::size_t i = 0; i < fate_count; ++i) {
    if (model.trees_by_fate[i] == 0) continue;
    const auto fate = static_cast<Fate>(i);
    const std::string text = std::string(fate_label(fate)) + " " + std::to_string(model.trees_by_fate[i]);
    const double width = 28.0 + 6.0 * static_cast<double>(text.size());
    if (x + width > chart_width) x = 8.0, y += 18.0;
    drawing.items.push_back(DrawCircle{{x + 5.0, y - 4.0}, 4.5, palette::fates[i], palette::fates[i], 0.45, fate == Fate::missing});
    drawing.items.push_back(DrawText{{x + 15.0, y}, text, 11.0, palette::text});
    x += width;
  }
  return y;
}

void draw_scale_bar(Drawing& drawing, double scale, double y) {
  const double length_m = nice_step(120.0 / scale, 1);
  const double right = chart_width - 12.0;
  drawing.items.push_back(DrawLine{{right - length_m * scale, y}, {right, y}, palette::text, 1.5});
  drawing.items.push_back(DrawText{{right - length_m * scale / 2.0, y - 5.0}, tick_text(length_m, length_m) + " m", 10.5, palette::text, TextAnchor::middle});
}

/// An arrow to true north in the map's upper right corner.
void draw_north(Drawing& drawing, double north_rad) {
  const DrawPoint middle{chart_width - 28.0, 34.0};
  const double dx = std::cos(north_rad), dy = -std::sin(north_rad);
  const DrawPoint tip{middle.x + 15.0 * dx, middle.y + 15.0 * dy}, left{middle.x - 11.0 * dx - 6.0 * dy, middle.y - 11.0 * dy + 6.0 * dx};
  const DrawPoint right{middle.x - 11.0 * dx + 6.0 * dy, middle.y - 11.0 * dy - 6.0 * dx}, notch{middle.x - 6.0 * dx, middle.y - 6.0 * dy};
  drawing.items.push_back(DrawPolygon{{tip, left, notch, right}, palette::text, palette::text});
  drawing.items.push_back(DrawText{{middle.x + 23.0 * dx, middle.y + 23.0 * dy + 3.5}, "N", 10.5, palette::text, TextAnchor::middle, true});
}

}  // namespace

Drawing draw_fate_map(const ReportModel& model) {
  const MapFrame frame = map_frame_of(model.trees);
  const double map_height = 16.0 + std::max(1.0, frame.high_m.y() - frame.low_m.y()) * frame.scale;
  Drawing drawing{chart_width, 0.0, "Map of the trees, coloured by what became of them", {}};
  drawing.items.push_back(DrawRect{0.0, 0.0, chart_width, map_height, "#FBFCFA"});
  // Circles at DBH scale would vanish on a map of hectares: enlarged, but never so that they hide their neighbours.
  const double enlarge = std::clamp(3.0 / frame.scale / 0.15, 1.0, 12.0);
  for (const TreeRow& tree : model.trees) {
    const auto fate = static_cast<std::size_t>(tree.fate);
    const double radius = std::clamp(tree.dbh_m.value_or(0.1) / 2.0 * enlarge * frame.scale, 0.8, 9.0);
    const bool hollow = tree.fate == Fate::outside_coverage;
    drawing.items.push_back(DrawCircle{frame.at(tree.position_m), radius, hollow ? "" : palette::fates[fate], palette::fates[fate], 0.45, tree.fate == Fate::missing});
  }
  if (model.north_rad) draw_north(drawing, *model.north_rad);
  draw_scale_bar(drawing, frame.scale, map_height + 20.0);
  const double last = draw_fate_legend(drawing, model, map_height + 46.0);
  drawing.height = last + 10.0;
  return drawing;
}

}  // namespace stemwise
