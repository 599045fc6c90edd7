#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/survey/frame_observations.hpp"

namespace stemwise {

/// One tree in the making: the observations that are held to be it, at most one per frame.
struct TreeNode {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  std::vector<std::size_t> observations;  ///< indices into FrameObservations::all, ascending
};

struct AssociateSettings {
  double radius_m = 0.6;        ///< an observation joins a tree within this
  double merge_radius_m = 0.4;  ///< two trees nearer than this, and hardly ever seen side by side, are one
  double noise_m = 0.08;        ///< scale of the robust position
  int rounds = 2;               ///< of merging and assigning anew
  bool only_reconstructed = false;
};

/// Groups observations into trees, one-to-one within each frame. `frame_weight` scales a frame's observations; a frame of
/// weight 0 starts no tree and moves none, yet its stems are counted with the trees they fall on. Deterministic: frames in
/// order, ties by index. Trees in order of their first observation.
std::vector<TreeNode> associate_observations(const FrameObservations& observations, std::span<const double> frame_weight,
                                             const AssociateSettings& settings);

/// Weighted robust (Cauchy) mean of planar positions.
Eigen::Vector2d robust_position(const FrameObservations& observations, std::span<const std::size_t> members,
                                std::span<const double> frame_weight, double noise_m);

}  // namespace stemwise
