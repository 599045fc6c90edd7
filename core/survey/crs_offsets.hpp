#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/forest/inventory.hpp"
#include "core/survey/alignment.hpp"

namespace stemwise {

/// How far a survey's coordinates lie from where the stems say it is, seen from what most surveys of the same system agree on.
struct CrsOffset {
  InventoryId inventory;
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();  ///< of the middle of its stems
  bool is_wrong = false;
};

/// For surveys that are given in one coordinate system: all that have a pose, a probable one too. Wrong is what lies more than 2.5 m off,
/// five times what the GNSS position of a plot's centre is off as a rule. Of two surveys nobody can say which: both are then wrong.
std::vector<CrsOffset> crs_offsets(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment);

/// What to say of wrong ones, a sentence each.
std::vector<std::string> crs_warnings(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment);

}  // namespace stemwise
