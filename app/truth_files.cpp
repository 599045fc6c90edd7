#include "app/truth_files.hpp"

#include <nlohmann/json.hpp>

#include "io/write_inventory.hpp"

namespace stemwise {

std::string truth_trees_csv(const SimulatedForest& forest, const std::vector<std::string>& columns) {
  std::string text = "tree_id";
  for (const std::string& year : columns) {
    for (const char* name : {"id_", "x_m_", "y_m_", "z_m_", "dbh_cm_", "fate_"}) text += "," + (name + year);
  }
  text += "\n";
  for (const TrueTree& tree : forest.trees) {
    text += tree.tree_id;
    for (std::size_t k = 0; k < columns.size() && k < tree.then.size(); ++k) {
      text += "," + tree.then[k].source_id + "," + exact_number(tree.x_m) + "," + exact_number(tree.y_m) + "," + exact_number(tree.z_m) + "," +
              exact_number(tree.then[k].dbh_cm) + "," + true_fate(tree, k);
    }
    text += "\n";
  }
  return text;
}

std::string truth_poses_json(const SimulatedForest& forest, const std::vector<std::string>& names) {
  nlohmann::ordered_json poses;
  for (std::size_t k = 0; k < forest.surveys.size(); ++k) {
    const Eigen::Matrix4d m = forest.surveys[k].truth_from_survey.matrix();
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (int r = 0; r < 4; ++r) rows.push_back({m(r, 0), m(r, 1), m(r, 2), m(r, 3)});
    poses["T_truth_from_" + names[k]] = rows;
  }
  return poses.dump(1) + "\n";
}

}  // namespace stemwise
