#include "io/read_whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace stemwise {
namespace {

constexpr std::size_t bytes_behind = 8;

}  // namespace

std::optional<FileBytes> read_whole_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  struct stat about {};
  std::optional<FileBytes> bytes;
  if (::fstat(file, &about) == 0 && S_ISREG(about.st_mode)) {
    const auto expected = static_cast<std::size_t>(about.st_size);
    bytes.emplace(FileBytes{std::make_unique_for_overwrite<char[]>(expected + 1 + bytes_behind), 0});
    while (bytes->size < expected) {
      const ssize_t got = ::read(file, bytes->data.get() + bytes->size, expected - bytes->size);
      if (got < 0) bytes.reset();
      if (got <= 0) break;
      bytes->size += static_cast<std::size_t>(got);
    }
    if (bytes) {
      bytes->data[bytes->size] = '\n';
      std::fill_n(bytes->data.get() + bytes->size + 1, bytes_behind, '\0');
    }
  }
  ::close(file);
  return bytes;
}

}  // namespace stemwise
