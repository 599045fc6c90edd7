#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/forest/inventory.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// A survey with its place, to compare outlines.
struct PlacedInventory {
  const Inventory* inventory = nullptr;
  RigidTransform reference_from_inventory;
};

/// Stems of other surveys at the border of what a list's own stems outline, in the list's frame: where a tree of the border died
/// or had not grown in yet, the outline of that year's stems draws back, though the plot is the same. Up to `most_together` stems in a row
/// are such trees; more of them side by side are ground that this survey may not have seen, and none of them counts.
///   outline: of the survey's own stems, in its own frame.
///   reach_m: how far outside it, or inside, such a tree may stand; neighbours nearer than 3 reach_m stand in a row.
std::vector<Eigen::Vector2d> shared_border(const PlacedInventory& survey, const Polygon& outline, std::span<const PlacedInventory> others, double reach_m);

}  // namespace stemwise
