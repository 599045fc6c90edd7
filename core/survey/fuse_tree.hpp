#pragma once
#include <span>

#include "core/project/project_state.hpp"
#include "core/survey/fusion_choices.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

/// One sighting of a tree, in the reference's frame.
struct Sighting {
  StemRef ref;
  const Stem* stem = nullptr;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> axis;
  double position_sd_m = 0.1;
  double dbh_error_m = 0.01;  ///< one measurement's standard deviation in that survey
};

/// Merges the sightings of one tree, earliest first (method.md 9, "fusion"): the DBH by the policy, with its source; the
/// position as the mean weighted by each survey's position noise; species of the newest sighting that names one; each
/// from the survey that a person chose, where one did. `best`: the least error to be expected (the survey's DBH error,
/// less for a stem seen well and often), of equals the newest; `mean`: weighted by 1 / DBH error squared.
/// Approximate diameters never enter. Fills position, has_z, position_sd, dbh, source, axis, species, first/last, times.
TreeRow fuse_tree(TreeId id, std::span<const Sighting> sightings, FusionPolicy policy, const FusionChoice& choice = {});

}  // namespace stemwise
