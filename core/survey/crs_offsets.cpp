#include "core/survey/crs_offsets.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/quantile.hpp"

namespace stemwise {
namespace {

constexpr double wrong_beyond_m = 2.5;

Eigen::Vector2d moved_by_m(const Inventory& inventory, const RigidTransform& reference_from_inventory) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Stem& stem : inventory.stems) middle += Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0)) / static_cast<double>(inventory.stems.size());
  return (reference_from_inventory * middle - middle).head<2>();
}

std::string metres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f m", value);
  return text.data();
}

}  // namespace

std::vector<CrsOffset> crs_offsets(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment) {
  std::vector<CrsOffset> offsets;
  std::vector<double> east_m, north_m;
  for (const Inventory* inventory : inventories)
    for (const InventoryAlignment& a : alignment.inventories) {
      const bool has_pose = a.status == AlignmentStatus::reference || a.status == AlignmentStatus::aligned || a.status == AlignmentStatus::probable;
      if (a.inventory != inventory->id || !has_pose || inventory->stems.empty()) continue;
      offsets.push_back({inventory->id, moved_by_m(*inventory, a.reference_from_inventory), false});
      east_m.push_back(offsets.back().offset_m.x());
      north_m.push_back(offsets.back().offset_m.y());
    }
  if (offsets.size() < 2) return offsets;
  const bool two = offsets.size() == 2;
  const Eigen::Vector2d agreed = two ? Eigen::Vector2d::Zero() : Eigen::Vector2d(median(east_m), median(north_m));
  for (CrsOffset& offset : offsets) {
    offset.offset_m -= agreed;
    offset.is_wrong = offset.offset_m.norm() > wrong_beyond_m;
  }
  if (two) offsets[0].is_wrong = offsets[1].is_wrong = offsets[0].is_wrong || offsets[1].is_wrong;
  return offsets;
}

std::vector<std::string> crs_warnings(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment) {
  const std::vector<CrsOffset> offsets = crs_offsets(inventories, alignment);
  const auto name_of = [&](InventoryId id) { return (*std::find_if(inventories.begin(), inventories.end(), [&](const Inventory* i) { return i->id == id; }))->name; };
  std::vector<std::string> warnings;
  if (offsets.size() == 2 && offsets[0].is_wrong) {
    const double apart_m = (offsets[0].offset_m - offsets[1].offset_m).norm();
    return {"by their stems " + name_of(offsets[0].inventory) + " and " + name_of(offsets[1].inventory) + " lie " + metres(apart_m) +
            " from where their coordinates put them: one of the two is placed wrongly (a plot centre's GNSS position?)"};
  }
  for (const CrsOffset& offset : offsets)
    if (offset.is_wrong)
      warnings.push_back(name_of(offset.inventory) + ": by its stems it lies " + metres(offset.offset_m.norm()) +
                         " from where its coordinates put it, and the other surveys agree: it is placed wrongly (a plot centre's GNSS position?)");
  return warnings;
}

}  // namespace stemwise
