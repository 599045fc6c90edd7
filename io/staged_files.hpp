#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise {

/// Files that belong together: each is written whole under another name, and all of them take their places only once every one is
/// there. What was staged and not put in place is gone with this object.
class StagedFiles {
 public:
  StagedFiles() = default;
  ~StagedFiles();
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  Result<Done> add(const std::string& path, std::string_view bytes);
  /// A file that is written already: `temporary_beside(path)`.
  void adopt(const std::string& path);
  Result<Done> put_in_place();

 private:
  std::vector<std::string> paths_;
};

}  // namespace stemwise
