#pragma once
#include <span>
#include <string>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

struct Scene;
struct TreePair;
struct WeightedPose;

/// Covariance of the error of `candidate_from_query`, both parts along the axes of the candidate scene's own frame:
/// rows 0 to 2 the error of the query's origin (m), rows 3 to 5 the small rotation vector d (rad) with
/// R_true = Exp(d) R_estimate.
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// From the residuals of paired trees in x, y, base height and axis, each kind with its own scale, and the priors of
/// `refine_pose`. One scene alone: before the poses of several are put together.
PoseCovariance pair_covariance(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                               const RigidTransform& candidate_from_query, const RefinePoseSettings& settings);

/// Of the mean of several poses of one query: the query's own share of `chosen` stays, what the scenes add is seen in how
/// their poses scatter around the mean, and neighbouring scenes are not independent. `poses` and `fused` in the survey's
/// frame, `chosen` and the result in the chosen candidate's.
PoseCovariance fused_covariance(const PoseCovariance& chosen, const Eigen::Matrix3d& survey_from_candidate_rotation,
                                std::span<const WeightedPose> poses, const RigidTransform& fused,
                                const CovarianceSettings& settings);

/// Squared Mahalanobis distance of the truth; 6 degrees of freedom where the covariance is right.
double mahalanobis_sq(const RigidTransform& estimate, const PoseCovariance& covariance, const RigidTransform& truth);
/// The 95 % quantile of chi-square with 6 degrees of freedom.
inline constexpr double chi_square_95_of_6 = 12.591587243743977;

}  // namespace stemwise::treeloc
