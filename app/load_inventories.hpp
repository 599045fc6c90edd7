#pragma once
#include <vector>

#include "app/read_inputs.hpp"

namespace stemwise {

/// Inventories ready to work with: read, and made one stem list where they came as frames.
struct LoadedInventories {
  ExitCode code = ExitCode::done;  ///< usage, or unusable_input when one of them has no usable row: then there are none
  std::vector<Inventory> inventories;
  std::string problem;  ///< the first error in one line; empty when there was none
};

/// Says every issue. Throws Cancelled.
LoadedInventories load_inventories(const std::vector<std::string>& paths, const ReadOverrides& overrides, Session& session,
                                   const Progress& progress);

}  // namespace stemwise
