#include "core/treeloc/refine_pose.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace stemwise::treeloc {
namespace {

/// Cauchy weight of a residual, squared, at a scale.
double cauchy(double residual_sq, double scale) { return 1.0 / (1.0 + residual_sq / (scale * scale)); }

PlanarPose refine_planar(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs, PlanarPose pose,
                         const RefinePoseSettings& settings) {
  std::vector<PlanarPair> points;
  for (const TreePair& p : pairs) {
    points.push_back({query.trees[p.query].position_m.head<2>(), candidate.trees[p.candidate].position_m.head<2>(), 1.0});
  }
  for (int i = 0; i < settings.iterations; ++i) {
    for (PlanarPair& p : points) p.weight = cauchy((pose * p.query - p.candidate).squaredNorm(), settings.planar_scale_m);
    pose = fit_planar_pose(points);
  }
  return pose;
}

/// Normal equations for (dz, roll, pitch, bias): b_C = b_Q + dz + bias - pitch x + roll y, and differences of axes.
struct TiltEquations {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  void add(const Eigen::Vector4d& row, double value, double weight) {
    normal += weight * row * row.transpose();
    right += weight * value * row;
  }
};

struct TiltPair {
  Eigen::Vector4d height_row;  ///< (1, y, -x, 1) in the candidate's aligned frame
  double height_difference_m;
  double height_weight;
  bool has_height, has_axes;
  Eigen::Vector2d axis_difference;
};

std::vector<TiltPair> tilt_pairs(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                 const PlanarPose& pose, const RefinePoseSettings& settings) {
  const RigidTransform lifted = pose.lifted();
  const std::vector<double> weights = height_weights(query, candidate, pairs, settings);
  std::vector<TiltPair> out;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SceneTree& q = query.trees[pairs[i].query];
    const SceneTree& c = candidate.trees[pairs[i].candidate];
    const Eigen::Vector3d at = lifted * q.position_m;
    const bool axes = q.has_axis() && c.has_axis();
    const Eigen::Vector3d difference = c.axis - lifted.rotation * q.axis;
    out.push_back(
        {{1.0, at.y(), -at.x(), 1.0}, c.position_m.z() - at.z(), weights[i], q.has_height && c.has_height, axes, difference.head<2>()});
  }
  return out;
}

double median_difference(const std::vector<TiltPair>& pairs) {
  std::vector<double> differences;
  for (const TiltPair& p : pairs) {
    if (p.has_height) differences.push_back(p.height_difference_m);
  }
  if (differences.empty()) return 0.0;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

/// What is known before any tree: scenes are nearly upright; a carried sensor keeps its height, and then it is base heights
/// that may be off together (method.md, section 12), else they are taken as they are.
void add_priors(TiltEquations& equations, double dz_m, double displacement_m, bool level_sensor,
                const RefinePoseSettings& settings) {
  const double tilt_weight = 1.0 / std::pow(radians(settings.tilt_prior_deg), 2);
  equations.add({0.0, 1.0, 0.0, 0.0}, 0.0, tilt_weight);
  equations.add({0.0, 0.0, 1.0, 0.0}, 0.0, tilt_weight);
  const double prior_m = settings.height_prior_m + settings.height_prior_per_m * displacement_m;
  if (level_sensor) equations.add({1.0, 0.0, 0.0, 0.0}, 0.0, cauchy(dz_m * dz_m, 3.0 * prior_m) / (prior_m * prior_m));
  const double bias_m = level_sensor ? settings.height_bias_m : 1e-3;
  equations.add({0.0, 0.0, 0.0, 1.0}, 0.0, 1.0 / (bias_m * bias_m));
}

/// (dz, roll, pitch, bias) by reweighted least squares.
Eigen::Vector4d solve_tilt(const std::vector<TiltPair>& pairs, double displacement_m, bool level_sensor,
                           const RefinePoseSettings& settings) {
  Eigen::Vector4d solution(0.0, 0.0, 0.0, 0.0);
  (level_sensor ? solution[3] : solution[0]) = median_difference(pairs);
  const double axis_scale = radians(settings.axis_scale_deg);
  const double height_weight = 1.0 / (settings.height_scale_m * settings.height_scale_m);
  for (int i = 0; i < settings.iterations; ++i) {
    TiltEquations equations;
    add_priors(equations, solution[0], displacement_m, level_sensor, settings);
    for (const TiltPair& p : pairs) {
      if (p.has_height) {
        const double r = p.height_difference_m - p.height_row.dot(solution);
        equations.add(p.height_row, p.height_difference_m, cauchy(r * r, settings.height_scale_m) * height_weight * p.height_weight);
      }
      if (p.has_axes) {
        const Eigen::Vector2d r = p.axis_difference - Eigen::Vector2d(solution[2], -solution[1]);
        const double weight = cauchy(r.squaredNorm(), axis_scale) / (axis_scale * axis_scale);
        equations.normal(2, 2) += weight;  // a difference in x is a pitch, one in y a negative roll
        equations.right[2] += weight * p.axis_difference.x();
        equations.normal(1, 1) += weight;
        equations.right[1] -= weight * p.axis_difference.y();
      }
    }
    if (equations.normal(0, 0) <= 0.0) equations.normal(0, 0) = 1.0;  // no height anywhere: none is observed
    solution = equations.normal.ldlt().solve(equations.right);
  }
  return solution;
}

}  // namespace

Fields RefinePoseSettings::fields(const std::string& prefix) {
  return {
      {prefix + ".planar_scale_m", "m", "Planar residual at which a pair counts half", &planar_scale_m},
      {prefix + ".height_scale_m", "m", "Noise of base heights; a residual of this size counts half", &height_scale_m},
      {prefix + ".few_clusters_share", "", "What the base height of a tree of one or two partial observations counts", &few_clusters_share},
      {prefix + ".axis_scale_deg", "deg", "Difference of two stem axes at which the pair counts half", &axis_scale_deg},
      {prefix + ".tilt_prior_deg", "deg", "How far axis alignment may leave a scene from upright", &tilt_prior_deg},
      {prefix + ".height_prior", "", "A carried sensor keeps its height above the ground", &height_prior},
      {prefix + ".height_prior_m", "m", "Standard deviation of the height difference of two poses at one spot", &height_prior_m},
      {prefix + ".height_prior_per_m", "m/m", "What it grows by per metre of displacement", &height_prior_per_m},
      {prefix + ".height_bias_m", "m", "How far base heights of a carried sensor's frame may be off together", &height_bias_m},
      {prefix + ".iterations", "", "Reweighted steps", &iterations}};
}

std::vector<double> height_weights(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                   const RefinePoseSettings& settings) {
  constexpr int several = 3;
  const auto weight_of = [&](const SceneTree& tree) { return tree.clusters < several ? settings.few_clusters_share : 1.0; };
  std::vector<double> weights;
  double largest = 0.0;
  for (const TreePair& p : pairs) {
    weights.push_back(weight_of(query.trees[p.query]) * weight_of(candidate.trees[p.candidate]));
    largest = std::max(largest, weights.back());
  }
  for (double& weight : weights) weight = largest > 0.0 ? weight / largest : 1.0;
  return weights;
}

RefinedPose refine_pose(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs, const PlanarPose& start,
                        const RefinePoseSettings& settings) {
  RefinedPose refined;
  refined.planar = refine_planar(query, candidate, pairs, start, settings);
  const bool level_sensor = settings.height_prior && query.level_sensor && candidate.level_sensor;
  const Eigen::Vector4d tilt =
      solve_tilt(tilt_pairs(query, candidate, pairs, refined.planar, settings), refined.planar.displacement_m(), level_sensor, settings);
  const RigidTransform correction{rotation_from({tilt[1], tilt[2], 0.0}), {0.0, 0.0, tilt[0]}};
  const RigidTransform candidate_upright{candidate.aligned_from_scene, Eigen::Vector3d::Zero()};
  const RigidTransform query_upright{query.aligned_from_scene, Eigen::Vector3d::Zero()};
  refined.candidate_from_query = candidate_upright.inverse() * correction * refined.planar.lifted() * query_upright;
  return refined;
}

}  // namespace stemwise::treeloc
