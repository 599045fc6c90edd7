#pragma once
#include <filesystem>
#include <string>

namespace stemwise {

/// Both names mean one file, also where there is none yet; false for an empty name.
inline bool names_same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  return fs::equivalent(a, b, error) || fs::weakly_canonical(fs::absolute(a, error), error) == fs::weakly_canonical(fs::absolute(b, error), error);
}

}  // namespace stemwise
