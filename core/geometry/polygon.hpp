#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

namespace stemwise {

/// A simple polygon in the plane, metres, counter-clockwise, not closed (the last corner is not the first again).
struct Polygon {
  std::vector<Eigen::Vector2d> corners_m;
  bool operator==(const Polygon& o) const { return corners_m == o.corners_m; }
  bool empty() const { return corners_m.size() < 3; }
};

double area_sq_m(const Polygon& polygon);
bool contains(const Polygon& polygon, const Eigen::Vector2d& point_m);
/// Distance to the nearest edge, 0 or more, inside as outside.
double distance_to_edge_m(const Polygon& polygon, const Eigen::Vector2d& point_m);
/// Andrew's monotone chain. Fewer than three distinct points: an empty polygon.
Polygon convex_hull(std::span<const Eigen::Vector2d> points_m);

}  // namespace stemwise
