#pragma once
#include <string>
#include <vector>

#include "core/simulate/simulate_forest.hpp"

namespace stemwise {

/// truth/trees.csv: tree_id, then id_Y, x_m_Y, y_m_Y, z_m_Y, dbh_cm_Y and fate_Y for every year Y, in the truth's frame.
/// `columns` names the states in TrueTree::then ("2015", ...).
std::string truth_trees_csv(const SimulatedForest& forest, const std::vector<std::string>& columns);
/// truth/poses.json: {"T_truth_from_2015": [[...], ...], ...}; one name per survey.
std::string truth_poses_json(const SimulatedForest& forest, const std::vector<std::string>& names);

}  // namespace stemwise
