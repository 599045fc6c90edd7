#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/scene_model.hpp"

namespace stemwise::render {

/// The terrain under the stems as a grid of heights, for display: means of the base heights, filled and smoothed.
struct Ground {
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  double step_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<double> height_m;      ///< row by row from the south, nodes
  std::vector<std::uint8_t> is_known;  ///< nodes near stems, a ring farther than what is drawn
  std::vector<float> inside;           ///< at the nodes: at least 0 where it is drawn; it ends where this is 0

  bool empty() const { return columns < 2 || rows < 2; }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
  Eigen::Vector3d node_m(int column, int row) const;
  double height_at_m(const Eigen::Vector2d& place_m) const;  ///< of the nearest node, bilinear inside; 0 for an empty ground
};

Ground estimate_ground(const SceneModel& scene);

}  // namespace stemwise::render
