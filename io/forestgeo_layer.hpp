#pragma once
#include "core/survey/tables.hpp"
#include "io/layer.hpp"

namespace stemwise {

/// The censuses as ForestGEO's stem tables have them: a row per tree and census from the tree's first one on, gx and gy in metres
/// from the whole-metre corner south-west of all trees in the reference's frame, dbh in millimetres, status A alive, D dead,
/// M missing inside the census's coverage (nobody said dead), none where the census did not look.
Layer forestgeo_layer(const ProjectState& state, const Tables& tables);

}  // namespace stemwise
