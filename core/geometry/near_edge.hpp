#pragma once
#include "core/geometry/polygon.hpp"

namespace stemwise {

/// Whether the polygon's edge comes nearer to the point than `limit_m`, inside as outside. Quick for outlines of thousands of
/// corners: only sides that reach the square around the point are measured.
bool is_near_edge(const Polygon& polygon, const Eigen::Vector2d& point_m, double limit_m);

}  // namespace stemwise
