#pragma once
#include <span>
#include <string>

#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/scene.hpp"

namespace stemwise::treeloc {

/// Residual roll and pitch from the axes of paired trees, yaw fixed (method.md, section 7.3).
struct EstimateRollPitchSettings {
  bool enabled = true;
  double inlier_deg = 2.5;
  double least_share = 0.5;
  int least_inliers = 5;
  Fields fields(const std::string& prefix);
};

/// The small rotation R with a_C ~ R Rz a_Q (eq. 11). Every pair proposes one (there are so few that none need be drawn at
/// random); the one with the most inliers is averaged over them. Identity when they are too few.
Eigen::Matrix3d estimate_roll_pitch(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                    const PlanarPose& pose, const EstimateRollPitchSettings& settings);

}  // namespace stemwise::treeloc
