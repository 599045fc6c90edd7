#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemwise {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double distance_to_segment_m(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {  // from the origin
  const Eigen::Vector2d along = b - a;
  const double length_sq = along.squaredNorm();
  const double t = length_sq > 0.0 ? std::clamp(-a.dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (a + t * along).norm();
}

/// Appends one chain of the hull (lower for ascending points, upper for descending ones), without its last point.
template <class Iterator>
void append_chain(Iterator first, Iterator last, std::vector<Eigen::Vector2d>& hull) {
  const std::size_t start = hull.size();
  for (Iterator p = first; p != last; ++p) {
    while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();
}

}  // namespace

double area_sq_m(const Polygon& polygon) {
  if (polygon.empty()) return 0.0;
  const Eigen::Vector2d origin = polygon.corners_m.front();  // differences first: UTM-sized numbers lose nothing
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.corners_m.size(); ++i)
    twice += cross(polygon.corners_m[i] - origin, polygon.corners_m[i + 1] - origin);
  return std::abs(twice) / 2.0;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point_m) {
  if (polygon.empty()) return false;
  constexpr double on_edge_m = 1e-9;
  bool inside = false;
  Eigen::Vector2d a = polygon.corners_m.back() - point_m;
  for (const Eigen::Vector2d& corner : polygon.corners_m) {
    const Eigen::Vector2d b = corner - point_m;
    if (std::min(a.y(), b.y()) > on_edge_m || std::max(a.y(), b.y()) < -on_edge_m) {  // neither met nor crossed
      a = b;
      continue;
    }
    if (distance_to_segment_m(a, b) <= on_edge_m) return true;
    if ((a.y() > 0.0) != (b.y() > 0.0) && (cross(a, b - a) > 0.0) == (b.y() > a.y())) inside = !inside;
    a = b;
  }
  return inside;
}

double distance_to_edge_m(const Polygon& polygon, const Eigen::Vector2d& point_m) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.corners_m.size(); ++i) {
    const Eigen::Vector2d& a = polygon.corners_m[i];
    const Eigen::Vector2d& b = polygon.corners_m[(i + 1) % polygon.corners_m.size()];
    nearest = std::min(nearest, distance_to_segment_m(a - point_m, b - point_m));
  }
  return nearest;
}

Polygon convex_hull(std::span<const Eigen::Vector2d> points_m) {
  std::vector<Eigen::Vector2d> sorted(points_m.begin(), points_m.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return {};
  Polygon hull;
  append_chain(sorted.begin(), sorted.end(), hull.corners_m);
  append_chain(sorted.rbegin(), sorted.rend(), hull.corners_m);
  if (hull.empty()) hull.corners_m.clear();  // all on one line
  return hull;
}

}  // namespace stemwise
