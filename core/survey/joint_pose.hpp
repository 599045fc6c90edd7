#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/field.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// A relative pose of two surveys as one scene that both saw proposes it: right or wrong on its own.
struct PoseConstraint {
  std::size_t a = 0, b = 0;                             ///< surveys, by index
  RigidTransform a_from_b;
  Eigen::Vector3d scene_in_b = Eigen::Vector3d::Zero(); ///< where the scene is, in survey b's frame: there it is exact
  double weight = 1.0;
};

struct JointPoseSettings {
  double agreement_m = 1.5;          ///< two constraints agree when one puts the other's scene this near
  double agreement_per_m = 0.03;     ///< and so much more per metre between the scenes (a small heading error, drift)
  double lever_m = 10.0;             ///< how far from a scene its heading and tilt are compared
  double noise_m = 0.3;              ///< scale of the robust kernel
  int least_support = 3;             ///< constraints that must agree for a pair to count
  Fields fields();
};

/// How the constraints of one pair of surveys fared.
struct PairSupport {
  std::size_t a = 0, b = 0;
  int constraints = 0;
  int accepted = 0;       ///< in agreement with the joint estimate
  int second_best = 0;    ///< support of the best pose that disagrees with it
  RigidTransform a_from_b;  ///< the consensus of the pair on its own
};

struct JointPoseReport {
  std::vector<std::optional<RigidTransform>> reference_from_survey;  ///< empty where nothing convincing connects it
  std::vector<char> accepted;                                        ///< per constraint
  std::vector<PairSupport> pairs;                                    ///< every pair that has constraints, a < b as met first
  double residual_rms_m = 0.0;                                       ///< of accepted constraints at their scenes
};

/// One rigid pose per survey from all constraints (method.md 9, multi-session registration without odometry): consensus
/// per pair, the best supported pairs first, then all poses together with a robust kernel. Deterministic.
JointPoseReport estimate_joint_poses(std::size_t surveys, std::size_t reference, std::span<const PoseConstraint> constraints,
                                     const JointPoseSettings& settings = {});

}  // namespace stemwise
