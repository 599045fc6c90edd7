#pragma once
#include "core/base/random.hpp"
#include "core/simulate/simulate_forest.hpp"

namespace stemwise {

/// The ground, as waves of 60 to 250 m.
Terrain random_terrain(double relief_m, Random& random);

/// The living trees of the first survey on a square stand from (0, 0): large trees first, each at a distance that grows with
/// both diameters, in a density that varies over the stand; some have a second stem. Planted: rows with a little jitter.
std::vector<TrueTree> first_stand(const SimulateSettings& settings, double side_m, const Terrain& terrain, Random& random);

/// Lets the stand grow, die, be felled and filled up for `years`; appends each tree's next state.
void let_years_pass(std::vector<TrueTree>& trees, double years, const SimulateSettings& settings, const Terrain* terrain, Random& random);

}  // namespace stemwise
