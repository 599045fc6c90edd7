#include "app/rough_poses.hpp"

#include <charconv>
#include <sstream>

#include "core/geometry/rigid_transform.hpp"
#include "core/project/commands.hpp"

namespace stemwise {
namespace {

constexpr const char* prefix = "rough_pose.";

/// The shortest text that is read back as the same number.
std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

bool is_rough_pose(const std::string& key) { return key.starts_with(prefix); }

std::vector<AlignHints::RoughPose> rough_poses(const ProjectState& state) {
  std::vector<AlignHints::RoughPose> poses;
  for (const auto& inventory : state.inventories) {
    const auto setting = state.settings.find(prefix + std::to_string(inventory->id.value));
    if (setting == state.settings.end() || inventory->id == state.reference) continue;
    std::istringstream words(setting->second);
    InventoryId reference;
    AlignHints::RoughPose pose;
    pose.inventory = inventory->id;
    if (!(words >> reference.value >> pose.x_m >> pose.y_m >> pose.yaw_rad >> pose.radius_m) || state.find(reference) == nullptr || !state.is_placed(reference)) continue;
    const RigidTransform there = state.reference_from_inventory(reference) * RigidTransform::planar(pose.x_m, pose.y_m, pose.yaw_rad);
    pose.x_m = there.translation_m.x();
    pose.y_m = there.translation_m.y();
    pose.yaw_rad = roll_pitch_yaw(there.rotation).yaw_rad;
    poses.push_back(pose);
  }
  return poses;
}

CommandPtr keep_rough_pose(const ProjectState& state, const AlignHints::RoughPose& rough) {
  const std::string value = std::to_string(state.reference.value) + " " + text_of(rough.x_m) + " " + text_of(rough.y_m) + " " + text_of(rough.yaw_rad) + " " + text_of(rough.radius_m);
  const Inventory* inventory = state.find(rough.inventory);
  std::vector<CommandPtr> commands;
  commands.push_back(set_setting(prefix + std::to_string(rough.inventory.value), value));
  return group("Rough position of " + (inventory != nullptr ? inventory->name : std::string("a survey")), std::move(commands));
}

}  // namespace stemwise
