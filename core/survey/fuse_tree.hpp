#pragma once
#include <span>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

/// One sighting of a tree, in the reference's frame.
struct Sighting {
  StemRef ref;
  const Stem* stem = nullptr;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> axis;
  double position_sd_m = 0.1;
};

/// Merges the sightings of one tree, earliest first (method.md 9, "fusion"): the DBH by the policy, with its source; the
/// position as the mean weighted by each survey's position noise; species of the newest sighting that names one.
/// Approximate diameters never enter. Fills position, has_z, position_sd, dbh, source, axis, species, first/last, times.
TreeRow fuse_tree(TreeId id, std::span<const Sighting> sightings, FusionPolicy policy);

}  // namespace stemwise
