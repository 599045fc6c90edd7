#include "io/write_whole_file.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/replace_file.hpp"

namespace stemwise {

Result<Done> write_whole_file(const std::string& path, const std::string& text) {
  const std::string beside = path + ".part" + std::to_string(getpid());
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  std::error_code code;
  if (out) std::filesystem::rename(beside, path, code);
  if (out && !code) return Done{};
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  return Result<Done>::failure(cannot_write(path, code ? code.message() : ""));
}

}  // namespace stemwise
