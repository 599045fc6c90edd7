#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// The motion [R(phi, psi), (0, 0, dz)] that brings the base heights of the pairs together after `candidate_from_query`
/// (eq. 12-14). By RANSAC, then least squares on the inliers; with too few of them, or not `joint`, the mean height
/// difference alone.
RigidTransform correct_vertical(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                const RigidTransform& candidate_from_query, const CorrectVerticalSettings& settings,
                                std::uint64_t seed);

}  // namespace stemwise::treeloc
