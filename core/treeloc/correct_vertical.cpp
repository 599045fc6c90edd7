#include "core/treeloc/correct_vertical.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "core/base/random.hpp"

namespace stemwise::treeloc {
namespace {

struct HeightPair {
  Eigen::Vector3d row;  ///< of (dz, phi, psi)
  double difference_m = 0.0;
};

std::vector<HeightPair> height_pairs(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                     const RigidTransform& transform) {
  std::vector<HeightPair> heights;
  for (const TreePair& p : pairs) {
    const SceneTree &q = query.trees[p.query], &c = candidate.trees[p.candidate];
    if (!q.has_height || !c.has_height) continue;
    const Eigen::Vector3d at = transform * q.position_m;
    heights.push_back({{1.0, at.y(), -at.x()}, c.position_m.z() - at.z()});
  }
  return heights;
}

/// Least squares of the pairs; nothing where they do not determine a plane.
template <class Pairs>
bool solve(const Pairs& pairs, Eigen::Vector3d& solution) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const HeightPair& p : pairs) {
    normal += p.row * p.row.transpose();
    right += p.difference_m * p.row;
  }
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(normal);
  if (ldlt.vectorD().minCoeff() < 1e-6) return false;
  solution = ldlt.solve(right);
  return true;
}

std::vector<HeightPair> agreeing(const std::vector<HeightPair>& pairs, const Eigen::Vector3d& solution, double inlier_m) {
  std::vector<HeightPair> inliers;
  for (const HeightPair& p : pairs) {
    if (std::abs(p.difference_m - p.row.dot(solution)) < inlier_m) inliers.push_back(p);
  }
  return inliers;
}

std::vector<HeightPair> largest_consensus(const std::vector<HeightPair>& pairs, const CorrectVerticalSettings& settings,
                                          std::uint64_t seed) {
  Random random(seed);
  std::vector<HeightPair> best, sample(static_cast<std::size_t>(settings.sample));
  for (int trial = 0; trial < settings.trials; ++trial) {
    for (HeightPair& s : sample) s = pairs[random.below(pairs.size())];
    Eigen::Vector3d solution;
    if (!solve(sample, solution)) continue;
    auto inliers = agreeing(pairs, solution, settings.inlier_m);
    if (inliers.size() > best.size()) best = std::move(inliers);
  }
  return best;
}

}  // namespace

Fields CorrectVerticalSettings::fields(const std::string& prefix) {
  return {{prefix + ".joint", "", "Correct roll and pitch together with the height", &joint},
          {prefix + ".inlier_m", "m", "Base heights that agree to within this are inliers", &inlier_m},
          {prefix + ".sample", "", "Pairs drawn per trial", &sample},
          {prefix + ".trials", "", "Trials", &trials},
          {prefix + ".least_inliers", "", "With fewer inliers the mean height difference is used", &least_inliers}};
}

RigidTransform correct_vertical(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                const RigidTransform& candidate_from_query, const CorrectVerticalSettings& settings,
                                std::uint64_t seed) {
  const auto heights = height_pairs(query, candidate, pairs, candidate_from_query);
  RigidTransform correction;
  if (heights.empty()) return correction;
  double mean_m = 0.0;
  for (const HeightPair& p : heights) mean_m += p.difference_m / static_cast<double>(heights.size());
  correction.translation_m.z() = mean_m;
  if (!settings.joint || static_cast<int>(heights.size()) < settings.sample) return correction;
  const auto inliers = largest_consensus(heights, settings, seed);
  Eigen::Vector3d solution;
  if (static_cast<int>(inliers.size()) < settings.least_inliers || !solve(inliers, solution)) return correction;
  correction.translation_m.z() = solution[0];
  correction.rotation = rotation_from({solution[1], solution[2], 0.0});
  return correction;
}

}  // namespace stemwise::treeloc
