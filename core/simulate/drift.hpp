#pragma once
#include <cstdint>

#include "core/forest/frame_set.hpp"

namespace stemwise {

/// The trajectory as an odometry that drifts would have it: steps too long or too short by `share`, and a heading that turns
/// away steadily, by `share` radians over the whole way, so that the end lies off by about that share of the way's length.
/// The first pose and what frames saw stay.
FrameSet with_drift(FrameSet frames, double share, std::uint64_t seed);

}  // namespace stemwise
