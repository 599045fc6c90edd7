#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/scene_model.hpp"

namespace stemwise::render {

/// A smooth surface over the map: how dense the stems stand, how often they were seen, how large their residuals are. Where
/// no stems are near it is not known and not drawn.
struct HeatGrid {
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  double step_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<float> value;            ///< at the nodes, row by row from the south: stems per ha, surveys, or metres
  std::vector<std::uint8_t> is_known;
  double low = 0.0, high = 1.0;        ///< of the colours
  Legend legend;

  bool empty() const { return columns < 2 || rows < 2; }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
};

HeatGrid estimate_heat(const SceneModel& scene, HeatMap kind);

}  // namespace stemwise::render
