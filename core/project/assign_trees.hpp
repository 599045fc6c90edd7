#pragma once
#include "core/project/project_state.hpp"

namespace stemwise {

/// Makes trees of all stems of placed inventories anew from the matches that join. A tree that keeps stems of an earlier
/// tree keeps its id, note and hand-given fate (where several claim one id, the one with most of its stems does, then the
/// one with the smallest stem). Joins that would put two stems of one inventory into a tree, or contradict a rejection,
/// are dropped from the automatic matches: decisions by hand go first.
void assign_trees(ProjectState& state);

}  // namespace stemwise
