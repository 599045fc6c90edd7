#include "app/rough_poses.hpp"

#include <charconv>
#include <sstream>

#include "core/geometry/rigid_transform.hpp"
#include "core/project/commands.hpp"
#include "core/project/rough_pose_key.hpp"

namespace stemwise {
namespace {

/// The shortest text that is read back as the same number.
std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::vector<AlignHints::RoughPose> rough_poses(const ProjectState& state) {
  std::vector<AlignHints::RoughPose> poses;
  for (const auto& inventory : state.inventories) {
    const auto setting = state.settings.find(rough_pose_key(inventory->id));
    if (setting == state.settings.end() || inventory->id == state.reference) continue;
    std::istringstream words(setting->second);
    InventoryId reference;
    AlignHints::RoughPose pose;
    pose.inventory = inventory->id;
    words >> reference.value >> pose.x_m >> pose.y_m >> pose.yaw_rad >> pose.radius_m >> pose.yaw_radius_rad >> pose.about_m.x() >> pose.about_m.y() >> pose.accepted;
    if (!words || state.find(reference) == nullptr || !state.is_placed(reference)) continue;
    const RigidTransform there = state.reference_from_inventory(reference) * RigidTransform::planar(pose.x_m, pose.y_m, pose.yaw_rad);
    pose.x_m = there.translation_m.x();
    pose.y_m = there.translation_m.y();
    pose.yaw_rad = roll_pitch_yaw(there.rotation).yaw_rad;
    poses.push_back(pose);
  }
  return poses;
}

CommandPtr accept_proposed_pose(const ProjectState& state, InventoryId id, EditStamp stamp) {
  const RigidTransform& pose = state.alignments.at(id).reference_from_inventory;
  AlignHints::RoughPose taken{id, pose.translation_m.x(), pose.translation_m.y(), roll_pitch_yaw(pose.rotation).yaw_rad};
  taken.radius_m = 3.0;
  taken.yaw_radius_rad = 0.1;
  taken.accepted = true;
  const std::vector<Stem>& stems = state.find(id)->stems;
  for (const Stem& stem : stems) taken.about_m += Eigen::Vector2d(stem.x_m, stem.y_m) / static_cast<double>(stems.size());
  return keep_rough_pose(state, taken, std::move(stamp));
}

CommandPtr keep_rough_pose(const ProjectState& state, const AlignHints::RoughPose& rough, EditStamp stamp) {
  std::string value = std::to_string(state.reference.value);
  for (const double number : {rough.x_m, rough.y_m, rough.yaw_rad, rough.radius_m, rough.yaw_radius_rad, rough.about_m.x(), rough.about_m.y()}) value += " " + text_of(number);
  value += rough.accepted ? " 1" : " 0";
  const Inventory* inventory = state.find(rough.inventory);
  std::vector<CommandPtr> commands;
  commands.push_back(set_setting(rough_pose_key(rough.inventory), value));
  std::string what = (rough.accepted ? "Accept the pose of " : "Rough position of ") + (inventory != nullptr ? inventory->name : std::string("a survey"));
  const auto found = state.alignments.find(rough.inventory);
  const bool was_proposed = found != state.alignments.end() && found->second.status == AlignmentStatus::probable;
  commands.push_back(log_decision(what, was_proposed ? "probable" : "not aligned", rough.accepted ? "accepted" : "given by hand", std::move(stamp)));
  return group(std::move(what), std::move(commands));
}

}  // namespace stemwise
