#pragma once
#include <cstdint>

#include "core/forest/frame_set.hpp"

namespace stemwise::treeloc {

// What the paper does to inventories to see how the method holds (its appendix F.3 and section IV-G). Every frame has its own
// stream of random numbers: the same seed gives the same trees, whatever else is done to them.

/// Forgets each tree with this probability (0..1).
FrameSet delete_trees(const FrameSet& frames, double share, std::uint64_t seed);

/// Adds Gaussian noise to tree centres (x and y each) and to diameters (measured and approximate ones alike; never below 1 cm).
FrameSet add_noise(const FrameSet& frames, double center_sd_m, double dbh_sd_m, std::uint64_t seed);

/// As if the sensor had been mounted turned: trees and poses change, what they mean in the survey does not.
FrameSet rotate_frames(const FrameSet& frames, const RollPitchYaw& old_from_new);

}  // namespace stemwise::treeloc
