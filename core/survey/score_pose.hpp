#pragma once
#include <optional>

#include "core/survey/refine_pose.hpp"

namespace stemwise {

/// What the stems say for and against one pose.
struct PoseScore {
  double log_likelihood_ratio = 0.0;  ///< Lambda
  int matched = 0;                    ///< K
  int a_inside = 0;                   ///< nA': nodes of a where b has looked
  int b_inside = 0;                   ///< nB'
  double share_a = 0.5;               ///< pA ~ K / nB': chance of a stem of b to be in a
  double share_b = 0.5;               ///< pB ~ K / nA'
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  ///< of the matched nodes, in a
  double radius_m = 0.0;                               ///< their root mean square distance from it
};

/// ln of how much likelier it is that two stems are one than that they met by chance, given that they are `distance_sq`
/// apart: ln[p P(r) g / (rho f)], the geometric mean of both directions, so that it does not matter which list is first.
struct PairEvidence {
  PairEvidence(const IndexedList& list_a, const IndexedList& list_b, const PoseFit& fit);
  double log_ratio(std::size_t a, std::size_t b, double distance_sq) const;  ///< without the shares

 private:
  const IndexedList& a_;
  const IndexedList& b_;
  double variance_;
  DbhModel forth_, back_;
};

/// Step 6 of stem-lists.md. With a scene: only its nodes, and those of b that lie around it.
PoseScore score_pose(const IndexedList& a, const IndexedList& b, const PoseFit& fit, const Scene* scene);

/// How far apart two poses put the stems that `score` matched.
double distance_between_m(const PlanarPose& p, const PlanarPose& q, const PoseScore& score);

}  // namespace stemwise
