#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/polygon.hpp"

namespace stemwise {

/// A part of the plane as square cells that belong to it or not: for unions, buffers and outlines of many points. Metres.
class RasterMask {
 public:
  /// Empty, around `points` with `margin_m` on every side. The cell grows where the extent would need more than four million.
  RasterMask(std::span<const Eigen::Vector2d> points, double margin_m, double cell_m);

  double cell_m() const { return cell_m_; }
  void set(const Eigen::Vector2d& point);
  bool at(const Eigen::Vector2d& point) const;
  std::size_t count() const;
  double area_sq_m() const { return static_cast<double>(count()) * cell_m_ * cell_m_; }

  /// All within `radius_m` of it / all farther than `radius_m` from what is outside it (Euclidean, by cell centres).
  RasterMask dilated(double radius_m) const;
  RasterMask eroded(double radius_m) const;
  /// How many parts it has that hang together over edges, and the largest of them (the first of equals; empty when it is).
  std::size_t part_count() const;
  RasterMask largest_part() const;
  /// The same without holes smaller than `area_sq_m`.
  RasterMask without_holes(double area_sq_m) const;

  /// One simple ring around it, which must be connected: holes are reached by a slit of a centimetre, so that area and
  /// "contains" stay right. Corners are cut and straight runs joined, to within half a cell.
  Polygon outline() const;

 private:
  RasterMask() = default;
  bool cell(int x, int y) const {
    return x >= 0 && y >= 0 && x < columns_ && y < rows_ && cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] != 0;
  }
  std::size_t place(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x); }
  RasterMask blank() const;
  std::vector<std::vector<std::size_t>> connected(bool inside) const;  ///< cells in (not in) it that hang together, part by part
  std::vector<double> distance_sq_to(bool inside) const;  ///< per cell, in cells squared, to the nearest cell that is (not) in it
  std::vector<std::vector<Eigen::Vector2d>> rings() const;

  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double cell_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> cells_;
};

}  // namespace stemwise
