#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise {

/// One file inside an archive.
struct ZipEntry {
  std::string name;
  std::string bytes;
};

/// A zip archive under the name `temporary_beside(path)`, whole or not at all; the same bytes for the same entries.
Result<Done> write_temporary_zip(const std::string& path, const std::vector<ZipEntry>& entries);
/// The same, put in the place of `path`.
Result<Done> write_zip(const std::string& path, const std::vector<ZipEntry>& entries);

}  // namespace stemwise
