#pragma once
#include "core/geometry/rigid_transform.hpp"
#include "core/survey/associate_surveys.hpp"

namespace stemwise {

/// The stems of an inventory in the plane of the reference, relative to `origin_m`.
PlacedSurvey place_survey(const Inventory& inventory, const RigidTransform& reference_from_inventory, const Eigen::Vector2d& origin_m, double noise_m);

/// The stems of an upright copy of an inventory: turned by `level_from_inventory`, heights and axes with them.
std::vector<Stem> moved_stems(const Inventory& inventory, const RigidTransform& to_from_inventory);

}  // namespace stemwise
