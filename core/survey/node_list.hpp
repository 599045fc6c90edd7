#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace stemwise {

/// A stem list as the search for poses sees it: places (single stems, or several stems at one spot) in the plane, relative
/// to `origin_m` so that UTM-sized coordinates lose nothing.
struct NodeList {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> at_m;              ///< relative to the origin
  std::vector<double> dbh_cm;                     ///< of the largest member; negative: not measured
  std::vector<std::vector<std::size_t>> members;  ///< indices of the stems

  std::size_t size() const { return at_m.size(); }
};

}  // namespace stemwise
