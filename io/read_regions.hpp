#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/geometry/polygon.hpp"

namespace stemwise {

/// Reads the polygons under `key` of a JSON file: {"key": [[[x, y], ...], ...]}, metres. Failure when the file is no such
/// thing or has no such key.
Result<std::vector<Polygon>> read_regions(const std::string& path, const std::string& key);

}  // namespace stemwise
