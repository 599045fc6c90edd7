#include "core/geometry/shared_area.hpp"

#include <algorithm>
#include <utility>

namespace stemwise {
namespace {

std::pair<double, double> heights(const Polygon& polygon) {
  double low = polygon.corners_m.front().y(), high = low;
  for (const auto& c : polygon.corners_m) low = std::min(low, c.y()), high = std::max(high, c.y());
  return {low, high};
}

/// Where a horizontal line enters and leaves the polygon, ascending, in pairs (even-odd rule).
std::vector<double> crossings(const Polygon& polygon, double y) {
  std::vector<double> at;
  const auto& corners = polygon.corners_m;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const auto &p = corners[j], &q = corners[i];
    if ((p.y() > y) == (q.y() > y)) continue;
    at.push_back(p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y()));
  }
  std::sort(at.begin(), at.end());
  return at;
}

double shared_length(const std::vector<double>& a, const std::vector<double>& b) {
  double length = 0.0;
  for (std::size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    length += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return length;
}

}  // namespace

double shared_area_sq_m(const Polygon& a, const Polygon& b) {
  if (a.empty() || b.empty()) return 0.0;
  const auto [a_low, a_high] = heights(a);
  const auto [b_low, b_high] = heights(b);
  const double low = std::max(a_low, b_low), high = std::min(a_high, b_high);
  if (high <= low) return 0.0;
  constexpr int lines = 2000;
  const double step = (high - low) / lines;
  double area = 0.0;
  for (int k = 0; k < lines; ++k) {
    const double y = low + (k + 0.5) * step;
    area += step * shared_length(crossings(a, y), crossings(b, y));
  }
  return area;
}

}  // namespace stemwise
