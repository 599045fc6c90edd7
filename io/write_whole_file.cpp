#include "io/write_whole_file.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace stemwise {

Result<Done> write_whole_file(const std::string& path, const std::string& text) {
  const std::string beside = path + ".part" + std::to_string(getpid());
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  std::error_code code;
  if (out) std::filesystem::rename(beside, path, code);
  if (out && !code) return Done{};
  std::filesystem::remove(beside, code);
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "cannot be written", "does the folder exist, and may you write there?"});
}

}  // namespace stemwise
