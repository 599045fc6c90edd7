#pragma once
#include <span>

#include "core/base/result.hpp"
#include "core/geometry/polygon.hpp"

namespace stemwise {

/// Corners as a person clicked them, in any direction, as a polygon: counter-clockwise. An error issue for fewer than three
/// corners, less than a square metre, or sides that cross.
Result<Polygon> drawn_polygon(std::span<const Eigen::Vector2d> corners_m);

}  // namespace stemwise
