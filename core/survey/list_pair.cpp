#include "core/survey/list_pair.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise {
namespace {

constexpr std::size_t density_neighbours = 12;

std::vector<double> local_densities(const NodeList& nodes, const PlanarIndex& index) {
  std::vector<double> result(nodes.size(), 1.0);
  if (nodes.size() < 3) return result;
  const std::size_t k = std::min(density_neighbours, nodes.size() - 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double radius_m = std::max(0.5, index.distance_to_kth_m(nodes.at_m[i], k + 1));  // the node itself is the first
    result[i] = static_cast<double>(k) / (std::numbers::pi * radius_m * radius_m);
  }
  return result;
}

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hull_of(std::span<const Eigen::Vector2d> points) {
  std::vector<Eigen::Vector2d> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const auto& p : sorted) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

/// Inside the hull, or at most `margin_m` outside one of its sides.
bool near_hull(const std::vector<Eigen::Vector2d>& hull, const Eigen::Vector2d& p, double margin_m) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d& a = hull[i];
    const Eigen::Vector2d& b = hull[(i + 1) % hull.size()];
    const double length = (b - a).norm();
    if (length > 0.0 && cross(a, b, p) < -margin_m * length) return false;
  }
  return true;
}

}  // namespace

Support::Support(std::span<const Eigen::Vector2d> points) {
  if (points.size() < 3) return;
  constexpr double reach_in_spacings = 1.5, most_cells = 1e6, edge_m = 0.75;
  const PlanarIndex index(points, PlanarIndex::usual_cell_m(points));
  std::vector<double> spacing;
  for (const auto& p : points) spacing.push_back(index.distance_to_kth_m(p, std::min<std::size_t>(7, points.size())));
  std::nth_element(spacing.begin(), spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2), spacing.end());
  // Six neighbours within r mean a spacing of about r / sqrt(6 / pi).
  const double reach_m = std::max(1.0, reach_in_spacings * spacing[spacing.size() / 2] / 1.38);
  Eigen::Vector2d high = low_ = points[0];
  for (const auto& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
  low_.array() -= edge_m, high.array() += edge_m;
  const Eigen::Vector2d size = high - low_;
  cell_m_ = std::max({0.25 * reach_m, std::sqrt(size.x() * size.y() / most_cells)});
  columns_ = static_cast<int>(size.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size.y() / cell_m_) + 1;
  inside_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  const int reach = static_cast<int>(std::ceil(reach_m / cell_m_));
  for (const auto& p : points) {
    const int x = static_cast<int>((p.x() - low_.x()) / cell_m_), y = static_cast<int>((p.y() - low_.y()) / cell_m_);
    for (int v = std::max(0, y - reach); v <= std::min(rows_ - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(columns_ - 1, x + reach); ++u)
        if ((u - x) * (u - x) + (v - y) * (v - y) <= reach * reach) inside_[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u)] = 1;
  }
  const auto hull = hull_of(points);
  for (int v = 0; v < rows_; ++v)
    for (int u = 0; u < columns_; ++u) {
      auto& cell = inside_[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u)];
      if (cell != 0 && !near_hull(hull, low_ + cell_m_ * Eigen::Vector2d(u + 0.5, v + 0.5), edge_m + 0.5 * cell_m_)) cell = 0;
    }
}

double Support::area_sq_m() const {
  return cell_m_ * cell_m_ * static_cast<double>(std::count(inside_.begin(), inside_.end(), std::uint8_t{1}));
}

IndexedList::IndexedList(NodeList list)
    : nodes(std::move(list)),
      index(nodes.at_m, PlanarIndex::usual_cell_m(nodes.at_m)),
      support(nodes.at_m),
      dbh_density(nodes.dbh_cm),
      density_per_sq_m(local_densities(nodes, index)) {
  for (const double d : nodes.dbh_cm) dbh_density_at.push_back(d > 0.0 ? dbh_density.at(d) : 1.0);
  any_dbh = !dbh_density.empty();
  if (nodes.size() == 0) return;
  low_m = high_m = nodes.at_m[0];
  for (const auto& p : nodes.at_m) low_m = low_m.cwiseMin(p), high_m = high_m.cwiseMax(p);
}

NodeList mirrored(NodeList list) {
  for (auto& p : list.at_m) p.x() = -p.x();
  return list;
}

}  // namespace stemwise
