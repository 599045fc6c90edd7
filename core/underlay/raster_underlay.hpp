#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace stemwise {

/// A picture to lie under the stems, small enough to be kept, and where it lies: a net of nodes in the reference's frame.
struct RasterUnderlay {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgba;  ///< straight alpha, 4 bytes a pixel, top row first; alpha 0 where there is nothing
  int columns = 0;                 ///< nodes across and down, 2 or more each, evenly over the picture
  int rows = 0;
  std::vector<Eigen::Vector2d> nodes_in_reference_m;  ///< row by row from the picture's top
  double pixel_m = 0.0;            ///< what one pixel covers
  std::string system;              ///< "WGS 84 / UTM zone 33N"; empty: local coordinates
  bool is_terrain = false;         ///< heights, drawn as shaded relief

  const Eigen::Vector2d& node_m(int column, int row) const { return nodes_in_reference_m[static_cast<std::size_t>(row) * columns + column]; }
};

}  // namespace stemwise
