#include "render/ground.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr int most_nodes_per_side = 90;
constexpr double reach_in_steps = 2.2;  ///< from the nearest stem to the edge of what is drawn
constexpr int rings_around_stems = 4;     ///< known a little farther than that
constexpr int smoothing_passes = 3;

/// Mean base height of the stems around every node.
void take_means(const SceneModel& scene, Ground& ground) {
  std::vector<double> sum(ground.height_m.size(), 0.0);
  std::vector<int> count(ground.height_m.size(), 0);
  for (const Mark& mark : scene.marks) {
    const Eigen::Vector2d cell = (mark.base_m.head<2>() - ground.low_m) / ground.step_m;
    const int column = std::clamp(static_cast<int>(std::lround(cell.x())), 0, ground.columns - 1);
    const int row = std::clamp(static_cast<int>(std::lround(cell.y())), 0, ground.rows - 1);
    sum[ground.at(column, row)] += mark.base_m.z();
    ++count[ground.at(column, row)];
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (count[i] > 0) {
      ground.height_m[i] = sum[i] / count[i];
      ground.is_known[i] = 1;
    }
}

/// How far inside the drawn part every node lies: the reach less the distance to the nearest stem, in steps.
void measure_reach(const SceneModel& scene, Ground& ground) {
  constexpr int around = rings_around_stems;
  std::vector<double> distance(ground.height_m.size(), reach_in_steps + 1.0);
  for (const Mark& mark : scene.marks) {
    const Eigen::Vector2d cell = (mark.base_m.head<2>() - ground.low_m) / ground.step_m;
    const int column = static_cast<int>(std::lround(cell.x())), row = static_cast<int>(std::lround(cell.y()));
    for (int r = std::max(0, row - around); r <= std::min(ground.rows - 1, row + around); ++r)
      for (int c = std::max(0, column - around); c <= std::min(ground.columns - 1, column + around); ++c) {
        double& nearest = distance[ground.at(c, r)];
        nearest = std::min(nearest, (Eigen::Vector2d(c, r) - cell).norm());
      }
  }
  ground.inside.resize(distance.size());
  for (std::size_t i = 0; i < distance.size(); ++i) ground.inside[i] = static_cast<float>(reach_in_steps - distance[i]);
}

/// The mean of the known nodes in the 3 x 3 around one; nothing known: false.
bool neighbours_mean(const Ground& ground, const std::vector<std::uint8_t>& known, int column, int row, double& mean_m) {
  double sum = 0.0;
  int count = 0;
  for (int r = std::max(0, row - 1); r <= std::min(ground.rows - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(ground.columns - 1, column + 1); ++c)
      if (known[ground.at(c, r)]) {
        sum += ground.height_m[ground.at(c, r)];
        ++count;
      }
  if (count == 0) return false;
  mean_m = sum / count;
  return true;
}

void grow_and_smooth(Ground& ground) {
  for (int pass = 0; pass < rings_around_stems + smoothing_passes; ++pass) {
    const bool grows = pass < rings_around_stems;
    const std::vector<std::uint8_t> known = ground.is_known;
    std::vector<double> next = ground.height_m;
    for (int row = 0; row < ground.rows; ++row)
      for (int column = 0; column < ground.columns; ++column) {
        const std::size_t i = ground.at(column, row);
        if (grows == static_cast<bool>(known[i])) continue;
        double mean_m = 0.0;
        if (!neighbours_mean(ground, known, column, row, mean_m)) continue;
        next[i] = mean_m;
        ground.is_known[i] = 1;
      }
    ground.height_m = std::move(next);
  }
}

}  // namespace

Eigen::Vector3d Ground::node_m(int column, int row) const {
  return {low_m.x() + column * step_m, low_m.y() + row * step_m, height_m[at(column, row)]};
}

double Ground::height_at_m(const Eigen::Vector2d& place_m) const {
  if (empty()) return 0.0;
  const Eigen::Vector2d cell = (place_m - low_m) / step_m;
  const double x = std::clamp(cell.x(), 0.0, columns - 1.001), y = std::clamp(cell.y(), 0.0, rows - 1.001);
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const double u = x - column, v = y - row;
  return (1 - v) * ((1 - u) * height_m[at(column, row)] + u * height_m[at(column + 1, row)]) +
         v * ((1 - u) * height_m[at(column, row + 1)] + u * height_m[at(column + 1, row + 1)]);
}

Ground estimate_ground(const SceneModel& scene) {
  Ground ground;
  if (scene.empty()) return ground;
  const Eigen::Vector2d extent = (scene.high_m - scene.low_m).head<2>();
  ground.step_m = std::max({extent.maxCoeff() / most_nodes_per_side, 1.2 * scene.spacing_m, 0.5});
  const double border_m = rings_around_stems * ground.step_m;
  ground.low_m = scene.low_m.head<2>().array() - border_m;
  ground.columns = static_cast<int>(std::ceil((extent.x() + 2 * border_m) / ground.step_m)) + 1;
  ground.rows = static_cast<int>(std::ceil((extent.y() + 2 * border_m) / ground.step_m)) + 1;
  ground.height_m.assign(static_cast<std::size_t>(ground.columns) * ground.rows, 0.0);
  ground.is_known.assign(ground.height_m.size(), 0);
  take_means(scene, ground);
  grow_and_smooth(ground);
  measure_reach(scene, ground);
  return ground;
}

}  // namespace stemwise::render
