#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/forest/inventory.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "core/jobs/progress.hpp"
#include "core/simulate/simulate_settings.hpp"

namespace stemwise {

/// Smooth ground: a few long waves. Heights in metres.
struct Terrain {
  struct Wave {
    double east_per_m = 0.0, north_per_m = 0.0, phase_rad = 0.0, height_m = 0.0;
  };
  std::vector<Wave> waves;
  double height_m(double x_m, double y_m) const;
};

/// What one tree was at the time of one survey.
enum class TrueState { not_yet, alive, dead, removed };
struct TreeThen {
  TrueState state = TrueState::not_yet;
  double dbh_cm = 0.0;
  std::string source_id;  ///< in that survey's list; empty: not in it (missed, dead and gone, removed, not yet grown in)
};

/// One tree of the truth, in the truth's frame.
struct TrueTree {
  std::string tree_id;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::string species;
  std::vector<TreeThen> then;  ///< one per survey
};

/// The word of a tree's fate in one survey for `truth/trees.csv`: survivor, ingrowth, dead, removed, not_yet. `survivor` is
/// every living tree that was there at the survey before, and all of the first survey.
std::string true_fate(const TrueTree& tree, std::size_t survey);

struct SimulatedSurvey {
  Inventory inventory;
  RigidTransform truth_from_survey;
};

/// Surveys of one forest, and what was true.
struct SimulatedForest {
  std::vector<TrueTree> trees;
  std::vector<SimulatedSurvey> surveys;
};

/// A synthetic forest over several years (issue 2, part 10): terrain, spacing, DBH, growth, ingrowth, mortality, removals,
/// and surveys in frames of their own. The same settings give the same forest everywhere.
SimulatedForest simulate_forest(const SimulateSettings& settings, const Progress& progress = {});

/// The next survey of a real stem list, made the same way; `trees` are its stems with two states each (before, after), and
/// the truth's frame is the list's own. The date is the first of `settings.dates`, else five years later. An inventory with
/// frames is moved as it is (its frames keep what they saw; only the trajectory turns, tilts and shifts).
SimulatedForest simulate_resurvey(const Inventory& inventory, const SimulateSettings& settings);

}  // namespace stemwise
