#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/survey/chart_models.hpp"

namespace stemwise {
namespace {

constexpr std::size_t petal_count = 16;
constexpr double degrees_per_petal = 360.0 / petal_count;
constexpr double pi = std::numbers::pi;

std::string text_of(const char* format, double a, double b = 0.0) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// Clockwise from +y, 0 to 2 pi.
double azimuth_rad(const Eigen::Vector2d& way) {
  const double angle = std::atan2(way.x(), way.y());
  return angle < 0.0 ? angle + 2.0 * pi : angle;
}

struct Sector {
  std::vector<TreeId> trees;
  double sum_m = 0.0;
};

ChartPetal petal_of(std::size_t i, const Sector& sector, double longest) {
  ChartPetal petal;
  petal.from_rad = (static_cast<double>(i) - 0.5) * 2.0 * pi / petal_count;
  petal.to_rad = (static_cast<double>(i) + 0.5) * 2.0 * pi / petal_count;
  petal.trees = sector.trees;
  const auto n = static_cast<double>(sector.trees.size());
  petal.radius = std::sqrt(n / longest);  // the petal's area counts the stems
  petal.label = text_of("towards %.1f\u00B0: ", static_cast<double>(i) * degrees_per_petal) + std::to_string(sector.trees.size()) + (n == 1.0 ? " stem" : " stems");
  if (n > 0.0) petal.label += text_of(", %.1f cm on average", 100.0 * sector.sum_m / n);
  return petal;
}

}  // namespace

ChartModel residual_rose_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to) {
  ChartModel chart;
  const Inventory *earlier = state.find(from), *later = state.find(to);
  chart.title = "Direction of residuals, " + (earlier ? earlier->name : "?") + " to " + (later ? later->name : "?");
  std::array<Sector, petal_count> sectors;
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  std::size_t n = 0;
  for (const MatchRow& row : tables.matches) {
    if (row.state == MatchState::rejected || row.a.inventory != from || row.b.inventory != to) continue;
    const Eigen::Vector2d way_m = (state.stem_in_reference_m(row.b) - state.stem_in_reference_m(row.a)).head<2>();
    const auto sector = static_cast<std::size_t>(std::lround(azimuth_rad(way_m) / (2.0 * pi) * petal_count)) % petal_count;
    sectors[sector].trees.push_back(row.tree);
    sectors[sector].sum_m += way_m.norm();
    sum_m += way_m;
    ++n;
  }
  if (n == 0) {
    chart.empty_text = "No stems are matched yet. Align the surveys first.";
    return chart;
  }
  double most = 1.0;
  for (const Sector& sector : sectors) most = std::max(most, static_cast<double>(sector.trees.size()));
  for (std::size_t i = 0; i < petal_count; ++i) chart.petals.push_back(petal_of(i, sectors[i], most));
  const Eigen::Vector2d mean_m = sum_m / static_cast<double>(n);
  chart.note = std::to_string(n) + (n == 1 ? " stem" : " stems") + text_of(", mean shift %.1f cm towards %.0f\u00B0", 100.0 * mean_m.norm(), azimuth_rad(mean_m) * 180.0 / pi) +
               " (clockwise from the y axis)";
  chart.x = {"", "", -1.15, 1.15, {}, {}};
  chart.y = chart.x;
  return chart;
}

}  // namespace stemwise
