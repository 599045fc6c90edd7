#include "core/survey/shared_border.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/near_edge.hpp"
#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

constexpr std::size_t most_together = 3;
constexpr double row_in_reaches = 3.0;

/// Stems of one other survey, in the frame of the list, that the list has no stem for.
std::vector<Eigen::Vector2d> without_partner(const Inventory& other, const RigidTransform& list_from_other, const PlanarIndex& own) {
  constexpr double same_m = 1.0;
  std::vector<Eigen::Vector2d> left;
  for (const Stem& stem : other.stems) {
    if (!std::isfinite(stem.x_m) || !std::isfinite(stem.y_m)) continue;
    const Eigen::Vector2d at = (list_from_other * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0))).head<2>();
    if (own.distance_to_kth_m(at, 1) > same_m) left.push_back(at);
  }
  return left;
}

/// Those that stand in rows of `most_together` at most.
std::vector<Eigen::Vector2d> in_short_rows(const std::vector<Eigen::Vector2d>& stems, double neighbour_m) {
  if (stems.empty()) return {};
  std::vector<std::size_t> row(stems.size());
  std::iota(row.begin(), row.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (row[i] != i) i = row[i] = row[row[i]];
    return i;
  };
  const PlanarIndex index(stems, neighbour_m);
  for (std::size_t i = 0; i < stems.size(); ++i)
    index.within(stems[i], neighbour_m, [&](std::size_t j, double) { row[std::max(root(i), root(j))] = std::min(root(i), root(j)); });
  std::vector<std::size_t> members(stems.size(), 0);
  for (std::size_t i = 0; i < stems.size(); ++i) ++members[root(i)];
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < stems.size(); ++i)
    if (members[root(i)] <= most_together) kept.push_back(stems[i]);
  return kept;
}

}  // namespace

std::vector<Eigen::Vector2d> shared_border(const PlacedInventory& survey, const Polygon& outline, std::span<const PlacedInventory> others, double reach_m) {
  std::vector<Eigen::Vector2d> own_places, border;
  for (const Stem& stem : survey.inventory->stems)
    if (std::isfinite(stem.x_m) && std::isfinite(stem.y_m)) own_places.emplace_back(stem.x_m, stem.y_m);
  if (own_places.empty()) return border;
  const PlanarIndex own(own_places, PlanarIndex::usual_cell_m(own_places));
  const RigidTransform survey_from_reference = survey.reference_from_inventory.inverse();
  for (const PlacedInventory& other : others) {
    if (other.inventory == survey.inventory) continue;
    auto alone = without_partner(*other.inventory, survey_from_reference * other.reference_from_inventory, own);
    std::erase_if(alone, [&](const Eigen::Vector2d& at) { return contains(outline, at) && !is_near_edge(outline, at, reach_m); });
    for (const Eigen::Vector2d& at : in_short_rows(alone, row_in_reaches * reach_m))
      if (is_near_edge(outline, at, reach_m)) border.push_back(at);
  }
  return border;
}

}  // namespace stemwise
