#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/planar_index.hpp"
#include "core/geometry/planar_pose.hpp"
#include "core/survey/dbh_evidence.hpp"
#include "core/survey/node_list.hpp"

namespace stemwise {

/// Where a list has looked: near one of its stems, and not beyond them. What lies outside says nothing about a pose.
class Support {
 public:
  Support() = default;
  explicit Support(std::span<const Eigen::Vector2d> points);
  bool contains(const Eigen::Vector2d& p) const {
    const double x = (p.x() - low_.x()) / cell_m_, y = (p.y() - low_.y()) / cell_m_;
    if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_)) return false;
    return inside_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] != 0;
  }
  double area_sq_m() const;

 private:
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double cell_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> inside_;
};

/// One list with everything that the search asks it for. Coordinates as in its NodeList.
struct IndexedList {
  explicit IndexedList(NodeList list);
  NodeList nodes;
  PlanarIndex index;
  Support support;
  DbhDensity dbh_density;
  std::vector<double> density_per_sq_m;  ///< around each node, from its 12 nearest
  std::vector<double> dbh_density_at;    ///< of its own list at each node's DBH, per cm
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero(), high_m = Eigen::Vector2d::Zero();
  bool any_dbh = false;
  std::size_t size() const { return nodes.size(); }
};

/// The list seen in a mirror (x to -x): the decoy that measures what chance can do in this very stand.
NodeList mirrored(NodeList list);

}  // namespace stemwise
