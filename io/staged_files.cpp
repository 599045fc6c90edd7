#include "io/staged_files.hpp"

#include <filesystem>

#include "io/replace_file.hpp"

namespace stemwise {

StagedFiles::~StagedFiles() {
  std::error_code ignored;
  for (const std::string& path : paths_) std::filesystem::remove(temporary_beside(path), ignored);
}

Result<Done> StagedFiles::add(const std::string& path, std::string_view bytes) {
  paths_.push_back(path);
  return write_temporary(path, bytes);
}

void StagedFiles::adopt(const std::string& path) { paths_.push_back(path); }

Result<Done> StagedFiles::put_in_place() {
  for (const std::string& path : paths_)
    if (Result<Done> done = replace_file(temporary_beside(path), path); !done) return done;
  paths_.clear();
  return Done{};
}

}  // namespace stemwise
