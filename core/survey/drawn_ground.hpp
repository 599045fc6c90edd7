#pragma once
#include "core/survey/tables.hpp"

namespace stemwise {

/// False where the survey's coverage was drawn by a person and the place lies outside: what a survey saw beyond the ground
/// that a person gave it is in no figure that is divided by that ground's area.
bool is_on_drawn_ground(const Tables& tables, InventoryId survey, const Eigen::Vector3d& position_m);

}  // namespace stemwise
