#pragma once
#include "core/forest/inventory.hpp"
#include "core/geometry/polygon.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// A coverage polygon of an inventory's own frame in the plane of the reference. In a frame that leans, a corner's place
/// depends on the ground's height there: that of the stems around it (mean of the nearest ones with a base height; 0 where none has one).
Polygon place_coverage(const Polygon& in_inventory, const Inventory& inventory, const RigidTransform& reference_from_inventory);

}  // namespace stemwise
