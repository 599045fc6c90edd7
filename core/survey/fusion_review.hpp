#pragma once
#include <string>
#include <vector>

#include "core/survey/tables.hpp"

namespace stemwise {

/// Where the surveys do not agree on a merged tree, beyond what errors of measurement explain.
struct FusionConflict {
  TreeId tree;
  std::string attribute;              ///< "species", "dbh", "position", "status"
  std::vector<std::pair<InventoryId, std::string>> values;  ///< what each survey says, by date; DBH in cm
  std::string kept;                   ///< the merged value
  InventoryId source;                 ///< none where it comes from no one survey
  bool by_hand = false;
};

/// Conflicts of all trees, by tree: species that differ; a diameter that shrank, or grew beyond belief; a stem farther than a
/// metre and four position errors from the merged place; alive after dead.
std::vector<FusionConflict> fusion_conflicts(const ProjectState& state, const Tables& tables);

/// One square of ground, and how well the surveys looked at it.
struct ObservedSquare {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  ///< in the reference's frame
  int surveys = 0;                    ///< whose coverage holds its centre
  int trees = 0;                      ///< merged trees in it
  double seen_share = 0.0;            ///< sightings of those trees, of as many as those surveys could have had
};

struct ObservedGround {
  double square_m = 20.0;
  std::vector<double> ha_by_surveys;          ///< [k]: ground that k + 1 surveys looked at
  std::vector<ObservedSquare> under_observed;  ///< seen by fewer than all surveys, or with a share below 0.6; the worst first
};

/// Empty where no survey has a coverage. Squares are counted by their centres.
ObservedGround observed_ground(const Tables& tables);

}  // namespace stemwise
