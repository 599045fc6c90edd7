#pragma once
#include <span>

#include "core/forest/stem.hpp"
#include "core/survey/node_list.hpp"

namespace stemwise {

/// Step 1 of stem-lists.md: stems closer than `radius_m` become one node at their mean place with the DBH of the largest;
/// stems without a finite place are left out (dead ones stay: where they stand is evidence too). Nodes are in the order of their first stem.
NodeList merge_coincident(std::span<const Stem> stems, double radius_m);

}  // namespace stemwise
