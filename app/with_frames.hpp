#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/forest/inventory.hpp"

namespace stemwise {

/// A project holds a survey's trees and not its frames. For aligning again they are read from where the survey came from, so
/// that a rerun sees what the first run saw; where they are no longer there, or make other trees (drift that
/// was corrected), a note says so and the trees have to do.
std::shared_ptr<const Inventory> with_frames(std::shared_ptr<const Inventory> inventory, int threads, std::vector<std::string>& notes);

}  // namespace stemwise
