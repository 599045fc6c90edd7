#pragma once
#include "core/survey/tables.hpp"

namespace stemwise {

/// What another fusion policy would do to the merged trees.
struct PolicyEffect {
  int changed = 0;                ///< trees whose DBH would be another by 0.05 cm or more
  double mean_change_m = 0.0;     ///< of those
  double largest_change_m = 0.0;  ///< with its sign
  bool operator==(const PolicyEffect&) const = default;
};

/// `now`: the tables of `state` as they are. Values that a person chose stay under every policy.
PolicyEffect policy_effect(const ProjectState& state, const Tables& now, FusionPolicy policy);

}  // namespace stemwise
