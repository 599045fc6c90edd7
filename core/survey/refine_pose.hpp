#pragma once
#include <span>
#include <vector>

#include "core/survey/list_pair.hpp"
#include "core/survey/query_scenes.hpp"

namespace stemwise {

/// A pose with the noise and the DBH model that it was fitted with.
struct PoseFit {
  PlanarPose b_from_a;
  double noise_m = 1.0;      ///< one-axis standard deviation of matched stems' planar difference
  DbhModel dbh;
  double soft_matched = 0.0; ///< sum of the match probabilities
};

/// Step 5 of stem-lists.md: expectation-maximisation of the rigid pose over soft matches within three sigma. Sigma starts at
/// `start.noise_m` and shrinks by at most a quarter a step, not below `noise_floor_m`.
PoseFit refine_pose(const IndexedList& a, std::span<const std::size_t> nodes, const IndexedList& b, PoseFit start, double noise_floor_m);

/// Growth and spread of DBH re-estimated from the stems that the pose joins (robust: median and MAD); unchanged when fewer
/// than 8 pairs with DBH are there. A model of positions only learns to use DBH here.
DbhModel refit_dbh(const IndexedList& a, std::span<const std::size_t> nodes, const IndexedList& b, const PoseFit& fit);

}  // namespace stemwise
