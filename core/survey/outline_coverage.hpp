#pragma once
#include <span>

#include "core/forest/inventory.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

/// The outline of a cloud of points in the plane, tighter than its hull: gaps up to about five times the usual distance
/// between neighbours belong to it, bays and routes wider than that do not. Morphological closing on a raster, outer
/// boundary, simplified to less than a cell. Holes are filled. Points in several far-apart groups: their convex hull.
Polygon outline_of(std::span<const Eigen::Vector2d> points_m);

/// Where an inventory looked, as far as its stems tell, in its own frame.
Coverage outline_coverage(const Inventory& inventory);

}  // namespace stemwise
