#pragma once
#include <cstddef>
#include <optional>

#include "core/base/ids.hpp"

namespace stemwise {

/// A relative pose that the estimate of the trajectories did not believe.
struct RejectedConstraint {
  InventoryId a, b;
  std::optional<std::size_t> frame_a, frame_b;  ///< index of the frame; nothing for a bare list
  double residual_m = 0.0;                      ///< planar
};

}  // namespace stemwise
