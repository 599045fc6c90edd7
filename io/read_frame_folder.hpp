#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"

namespace stemwise {

/// True for a folder that holds `trajectory.txt` or any `TreeManagerState_<n>.csv` (whether it can be read is another matter).
bool is_frame_folder(const std::string& folder);

/// Reads a frame folder (data-formats.md): `trajectory.txt` (timestamp x y z qx qy qz qw, metres, seconds) and
/// `TreeManagerState_<n>.csv`, frame n being trajectory row n. The inventory has its `frames` set, in order of n, and no
/// `stems`: those are the business of core/survey. Columns are found by header, in any order. Every bad row is an issue
/// and is left out, every frame that has no pose or cannot be read is an issue and is left out; a failure only when there
/// is no trajectory or no usable frame. `threads` 0: all of the machine; the result does not depend on it.
Result<Inventory> read_frame_folder(const std::string& folder, int threads = 0);

}  // namespace stemwise
