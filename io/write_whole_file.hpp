#pragma once
#include <string>

#include "core/base/result.hpp"

namespace stemwise {

/// Writes beside `path` and renames: whoever looks sees the old file or the new one, whole. An issue when it cannot.
Result<Done> write_whole_file(const std::string& path, const std::string& text);

}  // namespace stemwise
