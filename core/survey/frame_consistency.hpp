#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/survey/associate_observations.hpp"
#include "core/survey/frame_observations.hpp"

namespace stemwise {

struct FrameConsistencySettings {
  double search_radius_m = 4.0;   ///< how far a frame may be displaced and still be recognised
  double displaced_m = 0.5;       ///< a vote farther from zero than this contradicts the trajectory
  double doubtful_m = 0.25;       ///< a median residual above this is listed too
  double residual_scale_m = 0.15; ///< weight 1 / (1 + (residual / scale)^2)
  double least_agreement = 0.3;   ///< share of a frame's stems that other frames must have seen
  double neighbour_m = 5.0;       ///< a frame with another pose this near is expected to agree with it
};

/// How well one frame's stems lie on the trees that other frames saw.
struct FrameConsistency {
  std::size_t frame = 0;
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  ///< add to its stems to make them agree; level frame, metres
  double agreement = 1.0;    ///< share of its reconstructed stems on a tree of other frames, after that
  double weight = 1.0;       ///< 0..1
  bool contradicts = false;  ///< displaced, or hardly any agreement, although other frames are near
};

/// Judges every frame against the trees. A displaced frame has put up ghosts beside the true trees, so trees count by how
/// many other frames saw them.
std::vector<FrameConsistency> judge_frames(const FrameObservations& observations, std::span<const TreeNode> trees,
                                           const FrameConsistencySettings& settings);

}  // namespace stemwise
