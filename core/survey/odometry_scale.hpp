#pragma once
#include <array>
#include <vector>

#include "core/forest/frame_set.hpp"

namespace stemwise {

struct OdometryScaleSettings {
  double link_m = 14.0;         ///< of way between the two frames of a link
  double link_step_m = 4.0;     ///< from one link to the next
  int least_matched = 12;       ///< stems that both frames of a link must share
  int least_links = 20;
  double least_change = 0.002;  ///< a smaller error of scale is left alone
};

/// How much longer the steps between frames are than the trajectory says.
struct OdometryScale {
  double scale = 1.0;            ///< true length over told length; 1 unless it is told to be something else
  std::array<double, 2> ci95{1.0, 1.0};
  int links = 0;
  bool significant = false;      ///< beyond its interval and beyond the least change
};

/// The scale of a trajectory's odometry from what its frames saw: stems that two frames a few metres apart share tell how far
/// apart the frames are. No loop and no second survey can tell that: a loop that is too large closes as well. Frames upright.
OdometryScale estimate_odometry_scale(const FrameSet& frames, int threads, const OdometryScaleSettings& settings = {});

/// The trajectory with every step so many times as long; the first pose stays.
FrameSet with_scaled_steps(FrameSet frames, double scale);

}  // namespace stemwise
