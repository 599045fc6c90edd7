#include "core/survey/place_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

constexpr std::size_t stems_around = 5;

/// Height of the ground at a place, from the stems around it.
class Ground {
 public:
  explicit Ground(const Inventory& inventory) : index_(places(inventory), PlanarIndex::usual_cell_m(places(inventory))) {
    for (const Stem& stem : inventory.stems)
      if (has_place(stem)) heights_m_.push_back(*stem.z_m);
  }
  double at(const Eigen::Vector2d& place) const {
    if (heights_m_.empty()) return 0.0;
    double sum = 0.0;
    const auto around = index_.nearest(place, std::min(stems_around, heights_m_.size()));
    for (const std::size_t i : around) sum += heights_m_[i];
    return sum / static_cast<double>(around.size());
  }

 private:
  static bool has_place(const Stem& stem) { return stem.z_m && std::isfinite(*stem.z_m) && std::isfinite(stem.x_m) && std::isfinite(stem.y_m); }
  static std::vector<Eigen::Vector2d> places(const Inventory& inventory) {
    std::vector<Eigen::Vector2d> at;
    for (const Stem& stem : inventory.stems)
      if (has_place(stem)) at.emplace_back(stem.x_m, stem.y_m);
    return at;
  }
  PlanarIndex index_;
  std::vector<double> heights_m_;
};

}  // namespace

Polygon place_coverage(const Polygon& in_inventory, const Inventory& inventory, const RigidTransform& reference_from_inventory) {
  Polygon placed;
  const bool leans = reference_from_inventory.rotation(2, 2) < 1.0 - 1e-10;
  const auto place = [&](const Eigen::Vector2d& corner, double height_m) {
    placed.corners_m.push_back((reference_from_inventory * Eigen::Vector3d(corner.x(), corner.y(), height_m)).head<2>());
  };
  if (!leans) {
    for (const Eigen::Vector2d& corner : in_inventory.corners_m) place(corner, 0.0);
    return placed;
  }
  const Ground ground(inventory);
  for (const Eigen::Vector2d& corner : in_inventory.corners_m) place(corner, ground.at(corner));
  return placed;
}

}  // namespace stemwise
