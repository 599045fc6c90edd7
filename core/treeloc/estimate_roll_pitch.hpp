#pragma once
#include <span>
#include <string>

#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// The small rotation R with a_C ~ R Rz a_Q (eq. 11). Every pair proposes one (there are so few that none need be drawn at
/// random); the one with the most inliers is averaged over them. Identity when they are too few.
Eigen::Matrix3d estimate_roll_pitch(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                    const PlanarPose& pose, const EstimateRollPitchSettings& settings);

}  // namespace stemwise::treeloc
