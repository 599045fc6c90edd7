#include "core/treeloc/pose_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "core/treeloc/fuse_poses.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/refine_pose.hpp"

namespace stemwise::treeloc {
namespace {

using Row = Eigen::Matrix<double, 7, 1>;  // x, y, z, three turns, bias of base heights
using Normal = Eigen::Matrix<double, 7, 7>;

double cauchy(double residual_sq, double scale) { return 1.0 / (1.0 + residual_sq / (scale * scale)); }

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// Residuals of one kind: rows with weights, and their own scale.
class Equations {
public:
  explicit Equations(double nominal_scale) : nominal_(nominal_scale) {}
  void add(const Row& row, double residual, double trust = 1.0) {
    const double weight = trust * cauchy(residual * residual, nominal_);
    normal_ += weight * row * row.transpose();
    sum_sq_ += weight * residual * residual;
    weights_ += weight;
    ++count_;
  }
  /// Information: the scale is what the residuals say, but never finer than a third of the nominal one.
  Normal information(int unknowns) const {
    if (count_ == 0) return Normal::Zero();
    const double freedom = std::max(1.0, static_cast<double>(count_ - unknowns)) * weights_ / count_;
    const double variance = std::max(sum_sq_ / freedom, nominal_ * nominal_ / 9.0);
    return normal_ / variance;
  }

private:
  double nominal_;
  Normal normal_ = Normal::Zero();
  double sum_sq_ = 0.0, weights_ = 0.0;
  int count_ = 0;
};

Normal prior_information(double displacement_m, bool level_sensor, const RefinePoseSettings& settings) {
  Normal prior = Normal::Zero();
  prior(3, 3) = prior(4, 4) = 1.0 / std::pow(radians(settings.tilt_prior_deg), 2);
  if (level_sensor) prior(2, 2) = 1.0 / std::pow(settings.height_prior_m + settings.height_prior_per_m * displacement_m, 2);
  prior(6, 6) = 1.0 / std::pow(level_sensor ? settings.height_bias_m : 1e-3, 2);
  return prior;
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

PoseCovariance turned(const PoseCovariance& covariance, const Eigen::Matrix3d& to_from) {
  PoseCovariance both = PoseCovariance::Zero();
  both.topLeftCorner<3, 3>() = both.bottomRightCorner<3, 3>() = to_from;
  return both * covariance * both.transpose();
}

/// Scatter of poses around their mean, in the survey's frame.
PoseCovariance scatter_of(std::span<const WeightedPose> poses, const RigidTransform& mean) {
  PoseCovariance scatter = PoseCovariance::Zero();
  double weights = 0.0;
  for (const WeightedPose& p : poses) {
    Eigen::Matrix<double, 6, 1> d;
    d << p.survey_from_query.translation_m - mean.translation_m,
        rotation_vector(p.survey_from_query.rotation * mean.rotation.transpose());
    scatter += p.weight * d * d.transpose();
    weights += p.weight;
  }
  return weights > 0.0 ? PoseCovariance(scatter / weights) : scatter;
}

}  // namespace

Fields CovarianceSettings::fields(const std::string& prefix) {
  return {{prefix + ".position_floor_m", "m", "Error of a position that no residual shows", &position_floor_m},
          {prefix + ".tilt_floor_deg", "deg", "Error of roll and pitch that no residual shows", &tilt_floor_deg},
          {prefix + ".yaw_floor_deg", "deg", "Error of yaw that no residual shows", &yaw_floor_deg},
          {prefix + ".shared_share", "", "Share of one scene's covariance that all scenes have in common", &shared_share},
          {prefix + ".scenes_per_independent", "", "So many neighbouring scenes say as much as one independent one",
           &scenes_per_independent},
          {prefix + ".inflation", "", "Factor on the whole covariance", &inflation}};
}

PoseCovariance pair_covariance(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                               const RigidTransform& candidate_from_query, const RefinePoseSettings& settings) {
  const RigidTransform aligned{candidate.aligned_from_scene * candidate_from_query.rotation * query.aligned_from_scene.transpose(),
                               candidate.aligned_from_scene * candidate_from_query.translation_m};
  Equations planar(settings.planar_scale_m), heights(settings.height_scale_m), axes(radians(settings.axis_scale_deg));
  std::vector<double> steps_m;
  for (const TreePair& p : pairs) {
    const SceneTree &q = query.trees[p.query], &c = candidate.trees[p.candidate];
    if (q.has_height && c.has_height) steps_m.push_back(c.position_m.z() - (aligned * q.position_m).z());
  }
  const bool level_sensor = settings.height_prior && query.level_sensor && candidate.level_sensor;
  const double bias_m = level_sensor ? median_of(steps_m) : 0.0;
  const std::vector<double> trusts = height_weights(query, candidate, pairs, settings);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SceneTree &q = query.trees[pairs[i].query], &c = candidate.trees[pairs[i].candidate];
    const Eigen::Vector3d at = aligned * q.position_m, lever = at - aligned.translation_m, off = c.position_m - at;
    planar.add((Row() << 1.0, 0.0, 0.0, 0.0, 0.0, -lever.y(), 0.0).finished(), off.x());
    planar.add((Row() << 0.0, 1.0, 0.0, 0.0, 0.0, lever.x(), 0.0).finished(), off.y());
    if (q.has_height && c.has_height)
      heights.add((Row() << 0.0, 0.0, 1.0, lever.y(), -lever.x(), 0.0, 1.0).finished(), off.z() - bias_m, trusts[i]);
    if (!q.has_axis() || !c.has_axis()) continue;
    const Eigen::Vector3d lean = c.axis - aligned.rotation * q.axis;
    axes.add((Row() << 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0).finished(), lean.x());
    axes.add((Row() << 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0).finished(), lean.y());
  }
  Normal information = prior_information(aligned.translation_m.head<2>().norm(), level_sensor, settings);
  information += planar.information(3) + heights.information(3) + axes.information(2);
  constexpr double unobserved_m = 100.0, unobserved_rad = 3.0;  // finite, so that it can be inverted
  for (int i = 0; i < 6; ++i) information(i, i) += 1.0 / std::pow(i < 3 ? unobserved_m : unobserved_rad, 2);
  const Normal covariance = information.inverse();
  return turned(covariance.topLeftCorner<6, 6>(), candidate.aligned_from_scene.transpose());
}

PoseCovariance fused_covariance(const PoseCovariance& chosen, const Eigen::Matrix3d& survey_from_candidate_rotation,
                                std::span<const WeightedPose> poses, const RigidTransform& fused,
                                const CovarianceSettings& settings) {
  PoseCovariance covariance = chosen;
  if (poses.size() >= 3) {
    const double independent = std::max(1.0, static_cast<double>(poses.size()) / settings.scenes_per_independent);
    covariance = settings.shared_share * chosen +
                 turned(scatter_of(poses, fused), survey_from_candidate_rotation.transpose()) / independent;
  }
  covariance.topLeftCorner<3, 3>().diagonal().array() += std::pow(settings.position_floor_m, 2);
  covariance.diagonal().segment<2>(3).array() += std::pow(radians(settings.tilt_floor_deg), 2);
  covariance(5, 5) += std::pow(radians(settings.yaw_floor_deg), 2);
  return settings.inflation * covariance;
}

double mahalanobis_sq(const RigidTransform& estimate, const PoseCovariance& covariance, const RigidTransform& truth) {
  Eigen::Matrix<double, 6, 1> d;
  d << truth.translation_m - estimate.translation_m, rotation_vector(truth.rotation * estimate.rotation.transpose());
  return d.dot(covariance.ldlt().solve(d));
}

}  // namespace stemwise::treeloc
