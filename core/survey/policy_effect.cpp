#include "core/survey/policy_effect.hpp"

#include <cmath>

namespace stemwise {

PolicyEffect policy_effect(const ProjectState& state, const Tables& now, FusionPolicy policy) {
  constexpr double least_m = 0.0005;
  PolicyEffect effect;
  if (policy == state.fusion) return effect;
  ProjectState other = state;
  other.fusion = policy;
  const Tables then = derive_tables(other);
  double sum_m = 0.0;
  for (const TreeRow& tree : then.trees) {
    const TreeRow* before = now.find(tree.tree);
    if (before == nullptr || !before->dbh_m || !tree.dbh_m) continue;
    const double change_m = *tree.dbh_m - *before->dbh_m;
    if (std::abs(change_m) < least_m) continue;
    ++effect.changed;
    sum_m += change_m;
    if (std::abs(change_m) > std::abs(effect.largest_change_m)) effect.largest_change_m = change_m;
  }
  if (effect.changed > 0) effect.mean_change_m = sum_m / effect.changed;
  return effect;
}

}  // namespace stemwise
