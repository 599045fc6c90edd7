#pragma once
#include <cstddef>
#include <string>

#include "core/treeloc/match_trees.hpp"

namespace stemwise::treeloc {

/// How far `pairs` matched trees are beyond what chance makes of two unrelated scenes: the log of the Poisson likelihood
/// ratio, k ln(k / lambda) - k + lambda, less the log of the number of poses that were tried (shifts within the gate at the
/// pairing radius, turns, scenes). Above 0: not chance. lambda is the expected number of pairs at a random pose: query trees
/// times the candidate's tree density times the pairing area times the share of diameters that agree.
double chance_evidence(int pairs, const PlanarTrees& query, const PlanarTrees& candidate, double radius_m, double tau_dbh_m,
                       double gate_m, std::size_t scenes);

}  // namespace stemwise::treeloc
