#include "core/underlay/thin_cloud.hpp"

#include <bit>
#include <cmath>

namespace stemwise {
namespace {

constexpr double growth = 1.3;
constexpr std::int64_t half_range = 1 << 20;  // cubes on either side of the first point, 21 bits an axis

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

/// 0 where the point is too far from the first one to be one cloud with it.
std::uint64_t key_of(const Eigen::Vector3d& cubes) {
  std::uint64_t key = 1;  // above all three fields: never 0
  for (int axis = 0; axis < 3; ++axis) {
    const double cube = std::floor(cubes[axis]);
    if (!(std::abs(cube) < static_cast<double>(half_range))) return 0;
    key = key << 21 | static_cast<std::uint64_t>(static_cast<std::int64_t>(cube) + half_range);
  }
  return key;
}

}  // namespace

CloudThinner::CloudThinner(std::size_t most_points, double finest_spacing_m, const Eigen::Vector3d& metres_per_unit)
    : most_points_(most_points), spacing_m_(finest_spacing_m), metres_per_unit_(metres_per_unit), slots_(std::bit_ceil(2 * most_points + 2), 0) {}

void CloudThinner::add(const RawPoint& point) {
  if (!point.position.allFinite()) return;
  if (points_.empty()) origin_ = point.position;
  if (!is_new(point.position)) return;
  points_.push_back(point);
  while (points_.size() > most_points_) grow();
}

bool CloudThinner::is_new(const Eigen::Vector3d& position) {
  const std::uint64_t key = key_of((position - origin_).cwiseProduct(metres_per_unit_) / spacing_m_);
  if (key == 0) return false;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = mixed(key) & mask;
  while (slots_[slot] != 0) {
    if (slots_[slot] == key) return false;
    slot = (slot + 1) & mask;
  }
  slots_[slot] = key;
  return true;
}

void CloudThinner::grow() {
  spacing_m_ *= growth;
  slots_.assign(slots_.size(), 0);
  std::size_t kept = 0;
  for (const RawPoint& point : points_) {
    if (is_new(point.position)) points_[kept++] = point;
  }
  points_.resize(kept);
}

}  // namespace stemwise
