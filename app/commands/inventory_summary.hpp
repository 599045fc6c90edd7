#pragma once
#include <nlohmann/json_fwd.hpp>
#include <Eigen/Core>
#include <optional>
#include <string>

#include "app/read_inputs.hpp"

namespace stemwise {

/// What `info` tells about one inventory, counted once for people and for JSON.
struct InventorySummary {
  std::size_t stems = 0;   ///< of a frame folder: over all frames
  std::size_t frames = 0;  ///< 0: not a frame folder
  std::size_t with_dbh = 0, with_z = 0, with_axis = 0, with_species = 0, dead = 0, removed = 0;
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();  ///< extent in the inventory's own frame
  Eigen::Vector2d high_m = Eigen::Vector2d::Zero();
};

InventorySummary summarize(const Inventory& inventory);
/// Lines for people, ended by a newline.
std::string info_text(const ReadInput& input);
/// All inputs as one JSON text.
std::string info_json(const std::vector<ReadInput>& inputs, const nlohmann::ordered_json& projects);

}  // namespace stemwise
