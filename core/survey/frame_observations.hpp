#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/forest/frame_set.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// One stem of one frame, brought to the survey's level frame (upright, about the middle of the poses). Metres.
struct Observation {
  std::size_t frame = 0;  ///< index into FrameSet::frames
  std::size_t stem = 0;   ///< index into its stems
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  bool has_height = false, has_axis = false, reconstructed = false;
  double weight = 1.0;    ///< inverse of the expected variance of the position, relative to a well-seen near stem
  Eigen::Vector2d plane() const { return position.head<2>(); }
};

/// All stems of all frames in one level frame. Levelled first, because a survey may lean: metres of base height bias must
/// not become decimetres in the plane.
struct FrameObservations {
  std::vector<Observation> all;            ///< by frame, then stem
  std::vector<std::size_t> first_of_frame; ///< frames + 1 entries: observations of frame f are [first[f], first[f + 1])
  std::vector<Eigen::Vector3d> pose_positions;  ///< of each frame, level frame
  RigidTransform level_from_survey;

  std::span<const Observation> of_frame(std::size_t frame) const {
    return std::span(all).subspan(first_of_frame[frame], first_of_frame[frame + 1] - first_of_frame[frame]);
  }
};

FrameObservations gather_observations(const FrameSet& frames);

}  // namespace stemwise
