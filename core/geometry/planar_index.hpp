#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace stemwise {

/// Points in the plane in square cells, for "who is within r of here". Metres. Order of answers is fixed: by cell, then index.
class PlanarIndex {
 public:
  PlanarIndex() = default;
  PlanarIndex(std::span<const Eigen::Vector2d> points, double cell_m);
  /// A cell size that puts about two points in each cell.
  static double usual_cell_m(std::span<const Eigen::Vector2d> points);

  /// Calls visit(index, distance squared) for every point within `radius_m` of `at`.
  template <class Visit>
  void within(const Eigen::Vector2d& at, double radius_m, Visit&& visit) const {
    if (points_.empty()) return;
    const int x0 = column(at.x() - radius_m), x1 = column(at.x() + radius_m);
    const int y0 = row(at.y() - radius_m), y1 = row(at.y() + radius_m);
    const double limit_sq = radius_m * radius_m;
    for (int y = y0; y <= y1; ++y) {
      const std::size_t first = start_[cell(x0, y)], last = start_[cell(x1, y) + 1];
      for (std::size_t k = first; k < last; ++k) {
        const double distance_sq = (points_[k] - at).squaredNorm();
        if (distance_sq <= limit_sq) visit(order_[k], distance_sq);
      }
    }
  }
  /// Distance to the k-th nearest point (k from 1); all points are visited when there are fewer.
  double distance_to_kth_m(const Eigen::Vector2d& at, std::size_t k) const;
  /// The k nearest points, nearest first, ties by index.
  std::vector<std::size_t> nearest(const Eigen::Vector2d& at, std::size_t k) const;
  std::size_t size() const { return points_.size(); }

 private:
  std::size_t cell(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x); }
  int column(double x_m) const;
  int row(double y_m) const;

  double cell_m_ = 1.0;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<std::size_t> start_;           ///< per cell, into points_
  std::vector<std::size_t> order_;           ///< the caller's index
  std::vector<Eigen::Vector2d> points_;      ///< sorted by cell
};

}  // namespace stemwise
