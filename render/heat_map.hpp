#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/scene_model.hpp"

namespace stemwise::render {

/// A smooth surface over the map: how dense the stems stand, how often they were seen, how large their residuals are. Where
/// no stems are near, and outside every survey's coverage, it is not known and not drawn.
struct HeatGrid {
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  double step_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<float> value;            ///< at the nodes, row by row from the south: stems per ha, surveys, or metres
  std::vector<std::uint8_t> is_known;
  std::vector<float> inside;           ///< at the nodes: at least 0 where it is drawn; it ends where this is 0
  double low = 0.0, high = 1.0;        ///< of the colours
  /// Around under-observed areas, where trees were seen in fewer than (n + 1) / 2 of n surveys on average: only for times seen.
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> under_observed_m;
  Legend legend;

  bool empty() const { return columns < 2 || rows < 2; }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
};

/// The line on which the grid's values are `level`: one segment per cell side pair that it crosses (marching squares);
/// cells with an unknown node have none. In the grid's frame, metres.
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> contour_of(const HeatGrid& heat, float level);

HeatGrid estimate_heat(const SceneModel& scene, HeatMap kind);

}  // namespace stemwise::render
