#include "render/heat_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/number_text.hpp"

namespace stemwise::render {
namespace {

constexpr int most_nodes_per_side = 160;
constexpr double kernel_in_spacings = 1.6;  ///< standard deviation of the smoothing
constexpr float least_weight = 0.15F;       ///< of a lone stem's own: farther away nothing is known
constexpr double sq_m_per_ha = 10'000.0;

/// The mark's value for a mean; nothing where it has none. A density counts every mark.
std::optional<float> value_of(const Mark& mark, HeatMap kind) {
  switch (kind) {
    case HeatMap::none: return std::nullopt;
    case HeatMap::density: return 1.0F;
    case HeatMap::times_seen: return mark.times_seen > 0 ? std::optional(static_cast<float>(mark.times_seen)) : std::nullopt;
    case HeatMap::residual: return mark.residual_m ? std::optional(static_cast<float>(*mark.residual_m)) : std::nullopt;
  }
  return std::nullopt;
}

/// A Gaussian along one direction; `stride` 1 for rows, `columns` for columns.
void blur(std::vector<float>& grid, int lines, int line_step, int length, int stride, double sigma_nodes) {
  const int reach = static_cast<int>(std::ceil(3.0 * sigma_nodes));
  std::vector<float> kernel(static_cast<std::size_t>(reach) + 1);
  for (int k = 0; k <= reach; ++k) kernel[static_cast<std::size_t>(k)] = static_cast<float>(std::exp(-0.5 * k * k / (sigma_nodes * sigma_nodes)));
  std::vector<float> line(static_cast<std::size_t>(length));
  for (int i = 0; i < lines; ++i) {
    float* first = grid.data() + static_cast<std::ptrdiff_t>(i) * line_step;
    for (int j = 0; j < length; ++j) {
      float sum = 0.0F;
      for (int k = std::max(-reach, -j); k <= std::min(reach, length - 1 - j); ++k)
        sum += kernel[static_cast<std::size_t>(std::abs(k))] * first[static_cast<std::ptrdiff_t>(j + k) * stride];
      line[static_cast<std::size_t>(j)] = sum;
    }
    for (int j = 0; j < length; ++j) first[static_cast<std::ptrdiff_t>(j) * stride] = line[static_cast<std::size_t>(j)];
  }
}

void blur(std::vector<float>& grid, const HeatGrid& shape, double sigma_nodes) {
  blur(grid, shape.rows, shape.columns, shape.columns, 1, sigma_nodes);
  blur(grid, shape.columns, 1, shape.rows, shape.columns, sigma_nodes);
}

/// Marks the nodes of one row that lie in the polygon: between every odd and the following even crossing of its outline.
void mark_row(const CoverageShape& shape, const HeatGrid& heat, int row, std::vector<float>& mask) {
  const double y = heat.low_m.y() + row * heat.step_m;
  std::vector<double> crossings;
  for (std::size_t i = 0; i < shape.corners_m.size(); ++i) {
    const Eigen::Vector2d &a = shape.corners_m[i], &b = shape.corners_m[(i + 1) % shape.corners_m.size()];
    if ((a.y() <= y) != (b.y() <= y)) crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const int first = std::max(0, static_cast<int>(std::ceil((crossings[i] - heat.low_m.x()) / heat.step_m)));
    const int last = std::min(heat.columns - 1, static_cast<int>(std::floor((crossings[i + 1] - heat.low_m.x()) / heat.step_m)));
    for (int column = first; column <= last; ++column) mask[heat.at(column, row)] = 1.0F;
  }
}

/// Above 0 where some survey looked, 0 about at the outline of its coverage; above 0 everywhere when no coverage is known.
std::vector<float> coverage_field(const SceneModel& scene, const HeatGrid& heat) {
  std::vector<float> mask(heat.value.size(), scene.coverages.empty() ? 1.0F : 0.0F);
  if (scene.coverages.empty()) return mask;
  for (const CoverageShape& shape : scene.coverages)
    for (int row = 0; row < heat.rows; ++row) mark_row(shape, heat, row, mask);
  constexpr double sigma_nodes = 1.0;  // turns the nodes' stairs into a line
  blur(mask, heat, sigma_nodes);
  const auto whole = static_cast<float>(2.0 * std::numbers::pi * sigma_nodes * sigma_nodes);
  for (float& share : mask) share = share / whole - 0.5F;
  return mask;
}

HeatGrid empty_grid(const SceneModel& scene) {
  HeatGrid heat;
  const Eigen::Vector2d extent = (scene.high_m - scene.low_m).head<2>();
  heat.step_m = std::max({extent.maxCoeff() / most_nodes_per_side, 0.5 * scene.spacing_m, 0.25});
  const double border_m = 2.0 * kernel_in_spacings * scene.spacing_m;
  heat.low_m = scene.low_m.head<2>().array() - border_m;
  heat.columns = static_cast<int>(std::ceil((extent.x() + 2.0 * border_m) / heat.step_m)) + 1;
  heat.rows = static_cast<int>(std::ceil((extent.y() + 2.0 * border_m) / heat.step_m)) + 1;
  heat.value.assign(static_cast<std::size_t>(heat.columns) * heat.rows, 0.0F);
  heat.is_known.assign(heat.value.size(), 0);
  return heat;
}

void describe(HeatGrid& heat, HeatMap kind) {
  std::vector<float> known;
  for (std::size_t i = 0; i < heat.value.size(); ++i)
    if (heat.is_known[i]) known.push_back(heat.value[i]);
  if (known.empty()) return;
  std::sort(known.begin(), known.end());
  const double scale = kind == HeatMap::residual ? 100.0 : 1.0;
  const double top = scale * known[static_cast<std::size_t>(0.98 * static_cast<double>(known.size() - 1))];
  const double step = nice_step(std::max(top, 1e-6) / 4.0);
  heat.high = std::ceil(top / step - 1e-6) * step / scale;
  heat.legend.title = kind == HeatMap::density ? "Stem density" : kind == HeatMap::times_seen ? "Times seen, mean" : "Residual, mean";
  heat.legend.unit = kind == HeatMap::density ? "per ha" : kind == HeatMap::residual ? "cm" : "";
  for (int i = 0; i <= 16; ++i) heat.legend.gradient.push_back(cividis(i / 16.0));
  for (double tick = 0.0; tick <= heat.high * scale + 1e-9; tick += step)
    heat.legend.ticks.push_back({tick / (heat.high * scale), number_text(tick, decimals_of(step))});
}

/// Where the line crosses the sides of one cell, in cell units.
std::vector<Eigen::Vector2d> crossings(const std::array<float, 4>& corner, float level) {
  static const std::array<Eigen::Vector2d, 4> at{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::vector<Eigen::Vector2d> found;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    if ((corner[i] < level) == (corner[k] < level)) continue;
    found.push_back(at[i] + static_cast<double>((level - corner[i]) / (corner[k] - corner[i])) * (at[k] - at[i]));
  }
  return found;
}

}  // namespace

std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> contour_of(const HeatGrid& heat, float level) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segments;
  const auto value = [&](int column, int row) { return heat.value[heat.at(column, row)]; };
  const auto known = [&](int column, int row) { return heat.is_known[heat.at(column, row)] != 0; };
  for (int row = 0; row + 1 < heat.rows; ++row)
    for (int column = 0; column + 1 < heat.columns; ++column) {
      if (!known(column, row) || !known(column + 1, row) || !known(column + 1, row + 1) || !known(column, row + 1)) continue;
      const auto points = crossings({value(column, row), value(column + 1, row), value(column + 1, row + 1), value(column, row + 1)}, level);
      const Eigen::Vector2d cell(column, row);
      for (std::size_t i = 0; i + 1 < points.size(); i += 2)
        segments.emplace_back(heat.low_m + heat.step_m * (cell + points[i]), heat.low_m + heat.step_m * (cell + points[i + 1]));
    }
  return segments;
}

HeatGrid estimate_heat(const SceneModel& scene, HeatMap kind) {
  if (kind == HeatMap::none || scene.empty()) return {};
  HeatGrid heat = empty_grid(scene);
  std::vector<float> weight(heat.value.size(), 0.0F);
  for (const Mark& mark : scene.marks) {
    const std::optional<float> value = value_of(mark, kind);
    if (!value) continue;
    const Eigen::Vector2d cell = (mark.base_m.head<2>() - heat.low_m) / heat.step_m;
    const std::size_t i = heat.at(std::clamp(static_cast<int>(std::lround(cell.x())), 0, heat.columns - 1),
                                  std::clamp(static_cast<int>(std::lround(cell.y())), 0, heat.rows - 1));
    heat.value[i] += *value;
    weight[i] += 1.0F;
  }
  const double sigma_m = kernel_in_spacings * scene.spacing_m, sigma_nodes = sigma_m / heat.step_m;
  blur(heat.value, heat, sigma_nodes);
  blur(weight, heat, sigma_nodes);
  const auto per_ha = static_cast<float>(sq_m_per_ha / (2.0 * std::numbers::pi * sigma_m * sigma_m));
  heat.inside = coverage_field(scene, heat);
  for (std::size_t i = 0; i < heat.value.size(); ++i) {
    heat.inside[i] = std::min(heat.inside[i], weight[i] / least_weight - 1.0F);
    heat.is_known[i] = heat.inside[i] >= 0.0F;
    heat.value[i] = kind == HeatMap::density ? heat.value[i] * per_ha : weight[i] > 0.0F ? heat.value[i] / weight[i] : 0.0F;
  }
  describe(heat, kind);
  if (kind == HeatMap::times_seen && scene.surveys >= 2) {
    const double level = 0.5 * (scene.surveys + 1);
    heat.under_observed_m = contour_of(heat, static_cast<float>(level));
    if (!heat.under_observed_m.empty()) heat.legend.entries.push_back({"Line: below " + number_text(level, 1) + " of " + std::to_string(scene.surveys) + " surveys", {}, MarkShape::hollow, std::nullopt});
  }
  return heat;
}

}  // namespace stemwise::render
