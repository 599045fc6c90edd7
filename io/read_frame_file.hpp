#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/forest/stem.hpp"

namespace stemwise {

/// Reads one `TreeManagerState_<n>.csv`: the stems around one pose, in that frame. Columns by header in any order and case;
/// location_x, location_y and one of dbh, dbh_approximation are needed. Every bad row is an issue and left out; failure
/// when the file cannot be read or lacks a needed column. A file with a header alone is a frame without trees.
Result<std::vector<Stem>> read_frame_file(const std::string& path);

}  // namespace stemwise
