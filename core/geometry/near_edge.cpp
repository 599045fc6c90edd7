#include "core/geometry/near_edge.hpp"

#include <algorithm>

namespace stemwise {
namespace {

bool side_is_near(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double limit_m) {  // to the origin
  if ((a.cwiseMin(b).array() >= limit_m).any() || (a.cwiseMax(b).array() <= -limit_m).any()) return false;
  const Eigen::Vector2d along = b - a;
  const double length_sq = along.squaredNorm();
  const double t = length_sq > 0.0 ? std::clamp(-a.dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (a + t * along).norm() < limit_m;
}

}  // namespace

bool is_near_edge(const Polygon& polygon, const Eigen::Vector2d& point_m, double limit_m) {
  if (polygon.empty()) return false;
  Eigen::Vector2d a = polygon.corners_m.back() - point_m;
  for (const Eigen::Vector2d& corner : polygon.corners_m) {
    const Eigen::Vector2d b = corner - point_m;
    if (side_is_near(a, b, limit_m)) return true;
    a = b;
  }
  return false;
}

}  // namespace stemwise
