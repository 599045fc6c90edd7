#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/forest/frame_set.hpp"

namespace stemwise {

/// Reads `timestamp x y z qx qy qz qw` per line (seconds, metres), blanks or commas between, `#` for comments. Element n is
/// the n-th line that is no comment; empty where that line is bad (an issue names it). Failure when no pose is usable.
Result<std::vector<std::optional<TrajectoryPose>>> read_trajectory(const std::string& path);

}  // namespace stemwise
