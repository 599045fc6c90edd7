#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace stemwise {

/// One point, relative to the cloud's origin.
struct CloudPoint {
  float x_m = 0.0F, y_m = 0.0F, z_m = 0.0F;
  float above_ground_m = 0.0F;  ///< above the lowest points around
  std::uint8_t red = 0, green = 0, blue = 0;
  std::uint8_t intensity = 0;   ///< stretched to 0..255
};

/// The points of one square of the cloud. Any first part of them is an even choice of all.
struct CloudTile {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// A point cloud to lie under and among the stems, thinned to what can be kept and drawn.
struct CloudUnderlay {
  Eigen::Vector3d origin_in_reference_m = Eigen::Vector3d::Zero();
  std::vector<CloudPoint> points;  ///< tile by tile
  std::vector<CloudTile> tiles;
  bool has_colour = false;
  bool has_intensity = false;
  double spacing_m = 0.0;          ///< one point at most per cube of this edge
  double tile_m = 0.0;             ///< edge of the squares
  std::int64_t points_in_file = 0;
  std::string system;              ///< "WGS 84 / UTM zone 33N"; empty: local coordinates
};

}  // namespace stemwise
