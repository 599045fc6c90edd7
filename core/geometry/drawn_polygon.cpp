#include "core/geometry/drawn_polygon.hpp"

#include <algorithm>

namespace stemwise {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) { return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()); }

bool sides_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
}

bool is_simple(std::span<const Eigen::Vector2d> at) {
  const std::size_t n = at.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k)
      if ((k + 1) % n != i && sides_cross(at[i], at[i + 1], at[k], at[(k + 1) % n])) return false;
  return true;
}

/// Positive for counter-clockwise corners.
double signed_area_sq_m(std::span<const Eigen::Vector2d> at) {
  double twice = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Eigen::Vector2d p = at[i] - at[0], q = at[(i + 1) % at.size()] - at[0];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

Result<Polygon> refused(const char* text) { return Result<Polygon>::failure(Issue{Severity::error, "", 0, "", text, "Click the corners in order around the ground"}); }

}  // namespace

Result<Polygon> drawn_polygon(std::span<const Eigen::Vector2d> corners_m) {
  if (corners_m.size() < 3) return refused("An area needs three corners or more");
  if (!is_simple(corners_m)) return refused("The sides of the area cross each other");
  const double area = signed_area_sq_m(corners_m);
  if (std::abs(area) < 1.0) return refused("The area is smaller than a square metre");
  Polygon polygon;
  polygon.corners_m.assign(corners_m.begin(), corners_m.end());
  if (area < 0.0) std::reverse(polygon.corners_m.begin(), polygon.corners_m.end());
  return polygon;
}

}  // namespace stemwise
