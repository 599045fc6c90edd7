#pragma once
#include <limits>

#include "core/survey/refine_pose.hpp"

namespace stemwise {

/// Step 5 of stem-lists.md, beyond the scene: grows the circle of nodes around the scene by half its radius at a time until it
/// holds the whole list, refining each time. A pose whose log-likelihood ratio within the circle stays below `convincing` and
/// gains nothing from a larger circle is one of chance: it is left as it is, since growing thousands of those to a large list
/// would take most of the time of a refusal.
PoseFit grow_pose(const IndexedList& a, const Scene& scene, const IndexedList& b, PoseFit start, double noise_floor_m,
                  double convincing = -std::numeric_limits<double>::infinity());

}  // namespace stemwise
