#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise {

/// A folder in memory for GDAL to write into (/vsimem/), gone with this object. Most of its text drivers do not tell that a
/// disk is full: what they made here is written by ourselves, whole or not at all.
class MemoryFolder {
 public:
  MemoryFolder();
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  std::string path_of(const std::string& name) const { return folder_ + "/" + name; }
  /// Names of the files in it, sorted.
  std::vector<std::string> names() const;
  /// The bytes of a file; empty when there is none of that name.
  std::string bytes_of(const std::string& name) const;

 private:
  std::string folder_;
};

}  // namespace stemwise
