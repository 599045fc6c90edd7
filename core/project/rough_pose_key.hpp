#pragma once
#include <string>

#include "core/base/ids.hpp"

namespace stemwise {

/// The project's setting that keeps the position which a person gave for a survey, or accepted: the number of the reference in whose
/// frame it is, a blank, and the rest (app/rough_poses). An empty value: none.
inline std::string rough_pose_key(InventoryId id) { return "rough_pose." + std::to_string(id.value); }
inline bool is_rough_pose_key(const std::string& key) { return key.starts_with("rough_pose."); }

}  // namespace stemwise
