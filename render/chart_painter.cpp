#include "render/chart_painter.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>

#include "render/number_text.hpp"
#include "render/paint/chart_canvas.hpp"

namespace stemwise::render {
namespace {

cairo_status_t append_text(void* target, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// cairo numbers its surfaces over the life of the process; the picture must not depend on how many there were.
std::string without_counter(std::string svg) {
  const std::string mark = "id=\"surface";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const std::size_t digits = at + mark.size(), end = svg.find('"', digits);
    svg.erase(digits, end - digits);
  }
  return svg;
}

std::string value_text(const ChartAxis& axis, double value) {
  if (axis.unit.empty()) return grouped_text(std::llround(value));
  return number_text(value, 1) + " " + axis.unit;
}

ChartHit hit_of_bar(const ChartModel& chart, const ChartBars& series, const ChartBar& bar) {
  std::string text = bar.label + ": " + grouped_text(std::llround(bar.value)) + (bar.value == 1.0 ? " stem" : " stems");
  if (chart.bars.size() > 1) text += " (" + series.name + ")";
  return {bar.trees, text};
}

std::optional<ChartHit> hit_petal(const ChartModel& chart, const Eigen::Vector2d& value) {
  constexpr double turn = 6.283185307179586;
  const double angle = std::atan2(value.x(), value.y());
  for (const ChartPetal& petal : chart.petals) {
    const double in = std::fmod(angle - petal.from_rad + 2.0 * turn, turn);
    if (in <= petal.to_rad - petal.from_rad && value.norm() <= std::max(petal.radius, 0.12)) return ChartHit{petal.trees, petal.label};
  }
  return std::nullopt;
}

bool crosses(const ChartPetal& petal, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const double middle = 0.5 * (petal.from_rad + petal.to_rad), reach = 0.6 * petal.radius;
  const Eigen::Vector2d at(reach * std::sin(middle), reach * std::cos(middle));
  return (at.array() >= low.array()).all() && (at.array() <= high.array()).all();
}

}  // namespace

bool ChartLayout::contains(const Eigen::Vector2d& pixel) const {
  return (pixel.array() >= low_px.array()).all() && (pixel.array() <= high_px.array()).all();
}

Eigen::Vector2d ChartLayout::value_at(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d share = (pixel - low_px).cwiseQuotient(high_px - low_px);
  return {low.x() + share.x() * (high.x() - low.x()), high.y() - share.y() * (high.y() - low.y())};
}

Eigen::Vector2d ChartLayout::pixel_of(const Eigen::Vector2d& value) const {
  const Eigen::Vector2d share = (value - low).cwiseQuotient(high - low);
  return {low_px.x() + share.x() * (high_px.x() - low_px.x()), high_px.y() - share.y() * (high_px.y() - low_px.y())};
}

ChartPicture paint_chart(const ChartModel& chart, const ChartStyle& style) {
  const PaintedImage picture(style.size, style.scale);
  ChartPicture painted;
  {
    const Canvas canvas(picture.cairo());
    painted.layout = paint_chart_on(canvas, chart, style.size.width / style.scale, style.size.height / style.scale, style);
  }
  painted.layout.low_px *= style.scale;
  painted.layout.high_px *= style.scale;
  painted.image = picture.image();
  return painted;
}

std::string chart_svg(const ChartModel& chart, const ChartStyle& style) {
  std::string text;
  cairo_surface_t* surface = cairo_svg_surface_create_for_stream(append_text, &text, style.size.width, style.size.height);
  cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
  cairo_t* cairo = cairo_create(surface);
  cairo_scale(cairo, style.scale, style.scale);
  {
    const Canvas canvas(cairo);
    paint_chart_on(canvas, chart, style.size.width / style.scale, style.size.height / style.scale, style);
  }
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return without_counter(std::move(text));
}

Result<Done> write_chart(const ChartModel& chart, const ChartStyle& style, const std::string& path) {
  if (path.ends_with(".svg")) {
    const std::string svg = chart_svg(chart, style);
    return write_bytes({svg.begin(), svg.end()}, path);
  }
  if (path.ends_with(".png")) return write_png(paint_chart(chart, style).image, path);
  return Result<Done>::failure(Issue{.file = path, .text = "a chart is written as .png or .svg"});
}

std::optional<ChartHit> hit_chart(const ChartModel& chart, const ChartLayout& layout, const Eigen::Vector2d& pixel, double tolerance_px) {
  if (!layout.contains(pixel)) return std::nullopt;
  if (!chart.petals.empty()) return hit_petal(chart, layout.value_at(pixel));
  const ChartPoint* nearest = nullptr;
  const ChartPoints* nearest_series = nullptr;
  double least_px = tolerance_px;
  for (const ChartPoints& series : chart.points)
    for (const ChartPoint& point : series.points) {
      const double distance_px = (layout.pixel_of({point.x, point.y}) - pixel).norm();
      if (distance_px > least_px) continue;
      least_px = distance_px;
      nearest = &point;
      nearest_series = &series;
    }
  if (nearest) {
    std::string text = tree_label(nearest->tree) + ": " + value_text(chart.y, nearest->y);
    if (nearest->y_error > 0.0) text += " \u00B1 " + number_text(nearest->y_error, 1);
    if (!nearest_series->is_joined) text += " at " + value_text(chart.x, nearest->x);
    return ChartHit{{nearest->tree}, text};
  }
  const Eigen::Vector2d value = layout.value_at(pixel);
  for (const ChartBars& series : chart.bars)
    for (const ChartBar& bar : series.bars)
      if (value.x() >= bar.x_low && value.x() < bar.x_high && bar.value > 0.0 && pixel.y() >= layout.pixel_of({0.0, bar.value}).y() - tolerance_px)
        return hit_of_bar(chart, series, bar);
  return std::nullopt;
}

std::vector<TreeId> trees_in_chart(const ChartModel& chart, const ChartLayout& layout, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px) {
  const Eigen::Vector2d low = layout.value_at({std::min(a_px.x(), b_px.x()), std::max(a_px.y(), b_px.y())});
  const Eigen::Vector2d high = layout.value_at({std::max(a_px.x(), b_px.x()), std::min(a_px.y(), b_px.y())});
  std::vector<TreeId> trees;
  for (const ChartPoints& series : chart.points)
    for (const ChartPoint& point : series.points)
      if (point.x >= low.x() && point.x <= high.x() && point.y >= low.y() && point.y <= high.y()) trees.push_back(point.tree);
  for (const ChartBars& series : chart.bars)
    for (const ChartBar& bar : series.bars)
      if (bar.x_high > low.x() && bar.x_low < high.x() && bar.value >= low.y()) trees.insert(trees.end(), bar.trees.begin(), bar.trees.end());
  for (const ChartPetal& petal : chart.petals)
    if (crosses(petal, low, high)) trees.insert(trees.end(), petal.trees.begin(), petal.trees.end());
  std::sort(trees.begin(), trees.end());
  trees.erase(std::unique(trees.begin(), trees.end()), trees.end());
  return trees;
}

std::string PaintedChartPictures::svg(const ChartModel& chart, int width_px, int height_px) const {
  return chart_svg(chart, {.size = {width_px, height_px}, .selected = {}});
}

std::vector<std::uint8_t> PaintedChartPictures::png(const ChartModel& chart, int width_px, int height_px, double scale) const {
  const PixelSize size{static_cast<int>(std::lround(width_px * scale)), static_cast<int>(std::lround(height_px * scale))};
  return png_bytes(paint_chart(chart, {.size = size, .scale = scale, .selected = {}}).image);
}

}  // namespace stemwise::render
