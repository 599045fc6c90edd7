#include "core/survey/joint_pose.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>

namespace stemwise {
namespace {

/// A point and where it should come to lie.
struct PointPair {
  Eigen::Vector3d from, to;
  double weight = 1.0;
};

/// Least squares rigid motion (Kabsch). Differences to the weighted middles: UTM-sized numbers lose nothing.
RigidTransform fit_rigid(std::span<const PointPair> pairs) {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (const PointPair& p : pairs) {
    from += p.weight * p.from;
    to += p.weight * p.to;
    total += p.weight;
  }
  from /= total;
  to /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const PointPair& p : pairs) covariance += p.weight * (p.to - to) * (p.from - from).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d rotation = svd.matrixU() * sign * svd.matrixV().transpose();
  return {rotation, to - rotation * from};
}

/// A constraint as four points: the scene and one lever's length from it along each axis, so that heading and tilt count.
void append_points(const PoseConstraint& c, const RigidTransform& target_from_a, const RigidTransform& source_from_b, double weight,
                   double lever_m, std::vector<PointPair>& pairs) {
  for (int k = -1; k < 3; ++k) {
    const Eigen::Vector3d in_b = c.scene_in_b + (k < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(lever_m * Eigen::Vector3d::Unit(k)));
    pairs.push_back({source_from_b * in_b, target_from_a * (c.a_from_b * in_b), weight});
  }
}

/// How far apart a constraint and a relative pose put the scene and its surroundings.
double disagreement_m(const PoseConstraint& c, const RigidTransform& a_from_b, double lever_m) {
  double sum = 0.0;
  for (int k = -1; k < 3; ++k) {
    const Eigen::Vector3d in_b = c.scene_in_b + (k < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(lever_m * Eigen::Vector3d::Unit(k)));
    sum += (c.a_from_b * in_b - a_from_b * in_b).squaredNorm() / 4.0;
  }
  return std::sqrt(sum);
}

bool agree(const PoseConstraint& one, const PoseConstraint& other, const JointPoseSettings& settings) {
  const double apart_m = (one.scene_in_b - other.scene_in_b).norm();
  return disagreement_m(one, other.a_from_b, settings.lever_m) <= settings.agreement_m + settings.agreement_per_m * apart_m;
}

using Indices = std::vector<std::size_t>;

/// The constraint with which most agree, and those; weights count, ties go to the first.
Indices largest_consensus(std::span<const PoseConstraint> constraints, const Indices& among, const JointPoseSettings& settings) {
  Indices best;
  double most = 0.0;
  for (const std::size_t h : among) {
    Indices support;
    double weight = 0.0;
    for (const std::size_t c : among)
      if (agree(constraints[c], constraints[h], settings)) {
        support.push_back(c);
        weight += constraints[c].weight;
      }
    if (weight > most) {
      most = weight;
      best = std::move(support);
    }
  }
  return best;
}

/// The consensus as one pose, reweighted; distant scenes make the heading exact.
RigidTransform refine_pair(std::span<const PoseConstraint> constraints, const Indices& support, const JointPoseSettings& settings) {
  RigidTransform a_from_b;
  for (int round = 0; round < 15; ++round) {
    std::vector<PointPair> points;
    for (const std::size_t c : support) {
      const double off = round == 0 ? 0.0 : disagreement_m(constraints[c], a_from_b, settings.lever_m) / settings.noise_m;
      append_points(constraints[c], {}, {}, constraints[c].weight / (1.0 + off * off), settings.lever_m, points);
    }
    a_from_b = fit_rigid(points);
  }
  return a_from_b;
}

struct Pair {
  PairSupport report;
  Indices all, support;
};

/// Constraints sorted by pair; those given as (b, a) count for the same pair as (a, b).
std::vector<Pair> consensus_per_pair(std::span<const PoseConstraint> constraints, const JointPoseSettings& settings) {
  std::map<std::pair<std::size_t, std::size_t>, Indices> by_pair;
  for (std::size_t c = 0; c < constraints.size(); ++c) by_pair[{constraints[c].a, constraints[c].b}].push_back(c);
  std::vector<Pair> pairs;
  for (auto& [key, all] : by_pair) {
    Pair pair;
    pair.all = all;
    pair.support = largest_consensus(constraints, all, settings);
    pair.report = {key.first, key.second, static_cast<int>(all.size()), static_cast<int>(pair.support.size()), 0, {}};
    pair.report.a_from_b = refine_pair(constraints, pair.support, settings);
    Indices rest;
    std::set_difference(all.begin(), all.end(), pair.support.begin(), pair.support.end(), std::back_inserter(rest));
    pair.report.second_best = static_cast<int>(largest_consensus(constraints, rest, settings).size());
    pairs.push_back(std::move(pair));
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.support.size() > y.support.size(); });
  return pairs;
}

using Poses = std::vector<std::optional<RigidTransform>>;

/// The best supported pair that reaches a new survey, again and again (Prim).
Poses place_along_tree(std::size_t surveys, std::size_t reference, const std::vector<Pair>& pairs, const JointPoseSettings& settings) {
  Poses poses(surveys);
  poses[reference] = RigidTransform{};
  for (bool grown = true; grown;) {
    grown = false;
    for (const Pair& pair : pairs) {
      const auto& [a, b] = std::pair(pair.report.a, pair.report.b);
      if (static_cast<int>(pair.support.size()) < settings.least_support || poses[a].has_value() == poses[b].has_value()) continue;
      if (poses[a])
        poses[b] = *poses[a] * pair.report.a_from_b;
      else
        poses[a] = *poses[b] * pair.report.a_from_b.inverse();
      grown = true;
      break;
    }
  }
  return poses;
}

/// Every survey in turn against all others, robustly; the reference stays.
void settle_together(std::size_t reference, std::span<const PoseConstraint> constraints, const Indices& used, const JointPoseSettings& settings, Poses& poses) {
  for (int round = 0; round < 20; ++round)
    for (std::size_t s = 0; s < poses.size(); ++s) {
      if (s == reference || !poses[s]) continue;
      std::vector<PointPair> points;
      for (const std::size_t i : used) {
        const PoseConstraint& c = constraints[i];
        if ((c.a != s && c.b != s) || !poses[c.a] || !poses[c.b]) continue;
        const double off = disagreement_m(c, poses[c.a]->inverse() * *poses[c.b], settings.lever_m) / settings.noise_m;
        const double weight = c.weight / (1.0 + off * off);
        if (c.b == s)
          append_points(c, *poses[c.a], {}, weight, settings.lever_m, points);
        else  // the other way round: where b, already placed, puts the points that a calls its own
          for (int k = -1; k < 3; ++k) {
            const Eigen::Vector3d in_b = c.scene_in_b + (k < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(settings.lever_m * Eigen::Vector3d::Unit(k)));
            points.push_back({c.a_from_b * in_b, *poses[c.b] * in_b, weight});
          }
      }
      if (!points.empty()) poses[s] = fit_rigid(points);
    }
}

}  // namespace

Fields JointPoseSettings::fields() {
  return {{"joint.agreement_m", "m", "Two scenes agree when one puts the other this near.", &agreement_m},
          {"joint.agreement_per_m", "", "And so much more per metre between them.", &agreement_per_m},
          {"joint.lever_m", "m", "How far from a scene its heading and tilt are compared.", &lever_m},
          {"joint.noise_m", "m", "Scale of the robust kernel.", &noise_m},
          {"joint.least_support", "", "Scenes that must agree for a pair of surveys to count.", &least_support}};
}

JointPoseReport estimate_joint_poses(std::size_t surveys, std::size_t reference, std::span<const PoseConstraint> constraints,
                                     const JointPoseSettings& settings) {
  JointPoseReport report;
  std::vector<Pair> pairs = consensus_per_pair(constraints, settings);
  Poses poses = place_along_tree(surveys, reference, pairs, settings);
  Indices used;
  for (const Pair& pair : pairs)
    if (static_cast<int>(pair.support.size()) >= settings.least_support) used.insert(used.end(), pair.support.begin(), pair.support.end());
  std::sort(used.begin(), used.end());
  settle_together(reference, constraints, used, settings, poses);
  report.accepted.assign(constraints.size(), 0);
  double sum_sq = 0.0;
  int accepted = 0;
  for (Pair& pair : pairs) {
    pair.report.accepted = 0;
    for (const std::size_t i : pair.all) {
      const PoseConstraint& c = constraints[i];
      if (!poses[c.a] || !poses[c.b]) continue;
      const double off_m = disagreement_m(c, poses[c.a]->inverse() * *poses[c.b], settings.lever_m);
      if (off_m > settings.agreement_m) continue;
      report.accepted[i] = 1;
      ++pair.report.accepted;
      ++accepted;
      sum_sq += off_m * off_m;
    }
    report.pairs.push_back(pair.report);
  }
  if (accepted > 0) report.residual_rms_m = std::sqrt(sum_sq / accepted);
  report.reference_from_survey = std::move(poses);
  return report;
}

}  // namespace stemwise
