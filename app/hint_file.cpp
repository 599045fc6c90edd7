#include "app/hint_file.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stemwise {
namespace {

using nlohmann::json;

constexpr const char* pairs_help = R"(expected {"inventory": "2023", "pairs": [["id in the reference", "id"], ...]})";

class HintReader {
 public:
  HintReader(const std::string& path, const ProjectState& state) : path_(path), state_(state) {}

  Result<AlignHints> read(const json& root) {
    if (root.is_array() && root.empty()) wrong("holds no hint", pairs_help);
    for (const json& hint : root.is_array() ? root : json::array({root})) read_one(hint);
    return has_error(issues_) ? Result<AlignHints>::failure(issues_) : Result<AlignHints>(hints_, issues_);
  }

 private:
  void wrong(const std::string& text, const std::string& help = "") { issues_.push_back({Severity::error, path_, 0, "", text, help}); }

  void read_one(const json& hint) {
    if (!hint.is_object() || !hint.contains("inventory") || !hint["inventory"].is_string()) return wrong("a hint names no inventory", pairs_help);
    const std::string name = hint["inventory"];
    const Inventory* inventory = state_.find(name);
    if (inventory == nullptr) return wrong("there is no inventory named '" + name + "'");
    if (inventory->id == state_.reference) return wrong("'" + name + "' is the reference itself");
    if (!hint.contains("pairs") && !hint.contains("pose")) return wrong("the hint for '" + name + "' has neither pairs nor a pose", pairs_help);
    if (hint.contains("pairs")) read_pairs(hint["pairs"], *inventory);
    if (hint.contains("pose")) read_pose(hint["pose"], *inventory);
  }

  void read_pairs(const json& pairs, const Inventory& inventory) {
    const Inventory& reference = *state_.find(state_.reference);
    if (!pairs.is_array()) return wrong("'pairs' is no list", pairs_help);
    for (const json& pair : pairs) {
      if (!pair.is_array() || pair.size() != 2) return wrong("a pair is not two ids: " + pair.dump(), pairs_help);
      const StemRef a = find(reference, pair[0]), b = find(inventory, pair[1]);
      if (a.index >= 0 && b.index >= 0) hints_.same_tree.push_back({a, b});
    }
  }

  StemRef find(const Inventory& inventory, const json& id) {
    const std::string text = id.is_string() ? id.get<std::string>() : id.dump();
    const auto found = std::find_if(inventory.stems.begin(), inventory.stems.end(), [&](const Stem& s) { return s.source_id == text; });
    if (found == inventory.stems.end()) {
      wrong(inventory.name + " has no stem with the id '" + text + "'");
      return {};
    }
    return {inventory.id, found - inventory.stems.begin()};
  }

  void read_pose(const json& pose, const Inventory& inventory) {
    AlignHints::RoughPose rough;
    rough.inventory = inventory.id;
    for (const char* key : {"x_m", "y_m", "yaw_deg"}) {
      if (!pose.is_object() || !pose.contains(key) || !pose[key].is_number()) return wrong(std::string("'pose' has no number ") + key);
    }
    rough.x_m = pose["x_m"];
    rough.y_m = pose["y_m"];
    rough.yaw_rad = radians(pose["yaw_deg"]);
    if (pose.contains("radius_m")) {
      if (!pose["radius_m"].is_number() || !(pose["radius_m"].get<double>() > 0.0)) return wrong("'radius_m' is no number above 0: " + pose["radius_m"].dump());
      rough.radius_m = pose["radius_m"];
    }
    hints_.rough_poses.push_back(rough);
  }

  const std::string& path_;
  const ProjectState& state_;
  AlignHints hints_;
  Issues issues_;
};

}  // namespace

Result<AlignHints> read_hint_file(const std::string& path, const ProjectState& state) {
  std::ifstream in(path);
  if (!in) return Result<AlignHints>::failure(Issue{Severity::error, path, 0, "", "cannot be read", ""});
  const json root = json::parse(in, nullptr, false);
  if (root.is_discarded()) return Result<AlignHints>::failure(Issue{Severity::error, path, 0, "", "is no JSON", pairs_help});
  return HintReader(path, state).read(root);
}

}  // namespace stemwise
