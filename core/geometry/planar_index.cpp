#include "core/geometry/planar_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemwise {
namespace {
constexpr double max_cells = 4e6;  // a few stray points kilometres away must not cost gigabytes
}

double PlanarIndex::usual_cell_m(std::span<const Eigen::Vector2d> points) {
  if (points.empty()) return 1.0;
  Eigen::Vector2d low = points[0], high = points[0];
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d size = (high - low).cwiseMax(1.0);
  return std::sqrt(2.0 * size.x() * size.y() / static_cast<double>(points.size()));
}

PlanarIndex::PlanarIndex(std::span<const Eigen::Vector2d> points, double cell_m) {
  if (points.empty()) return;
  Eigen::Vector2d high = low_ = points[0];
  for (const auto& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d size = high - low_;
  cell_m_ = std::max({cell_m, 1e-3, std::sqrt(size.x() * size.y() / max_cells), size.maxCoeff() / max_cells});
  columns_ = static_cast<int>(size.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size.y() / cell_m_) + 1;
  const auto cell_of = [&](const Eigen::Vector2d& p) { return cell(column(p.x()), row(p.y())); };
  start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const auto& p : points) ++start_[cell_of(p) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  order_.resize(points.size());
  points_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t place = next[cell_of(points[i])]++;
    order_[place] = i;
    points_[place] = points[i];
  }
}

int PlanarIndex::column(double x_m) const {
  return static_cast<int>(std::clamp(std::floor((x_m - low_.x()) / cell_m_), 0.0, static_cast<double>(columns_ - 1)));
}
int PlanarIndex::row(double y_m) const {
  return static_cast<int>(std::clamp(std::floor((y_m - low_.y()) / cell_m_), 0.0, static_cast<double>(rows_ - 1)));
}

std::vector<std::size_t> PlanarIndex::nearest(const Eigen::Vector2d& at, std::size_t k) const {
  std::vector<std::pair<double, std::size_t>> found;
  const double everything_m = 2.0 * cell_m_ * (columns_ + rows_) + (at - low_).norm();
  for (double radius_m = cell_m_;; radius_m *= 1.6) {
    found.clear();
    within(at, radius_m, [&](std::size_t i, double d_sq) { found.emplace_back(d_sq, i); });
    if (found.size() >= std::min(k, size()) || radius_m > everything_m) break;
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < std::min(k, found.size()); ++i) result.push_back(found[i].second);
  return result;
}

double PlanarIndex::distance_to_kth_m(const Eigen::Vector2d& at, std::size_t k) const {
  std::vector<double> found;
  const double everything_m = 2.0 * cell_m_ * (columns_ + rows_) + (at - low_).norm();
  for (double radius_m = cell_m_;; radius_m *= 1.6) {
    found.clear();
    within(at, radius_m, [&](std::size_t, double d_sq) { found.push_back(d_sq); });
    if (found.size() >= std::min(k, size()) || radius_m > everything_m) break;
  }
  if (found.empty()) return 0.0;
  const auto kth = found.begin() + static_cast<std::ptrdiff_t>(std::min(k, found.size()) - 1);
  std::nth_element(found.begin(), kth, found.end());
  return std::sqrt(*kth);
}

}  // namespace stemwise
