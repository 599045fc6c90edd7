#pragma once
#include <vector>

#include "core/forest/stem.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// One pose of a trajectory. `survey_from_frame` takes frame coordinates to the survey's frame.
struct TrajectoryPose {
  double timestamp_s = 0.0;
  RigidTransform survey_from_frame;
};

/// The trees around one pose, in that pose's frame (a "local inventory").
struct Frame {
  std::int64_t number = 0;  ///< n of TreeManagerState_<n>.csv, row n of the trajectory
  TrajectoryPose pose;
  std::vector<Stem> stems;
};

/// All frames of one survey in driving order.
struct FrameSet {
  std::vector<Frame> frames;
};

}  // namespace stemwise
