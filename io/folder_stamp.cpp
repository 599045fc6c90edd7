#include "io/folder_stamp.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <vector>

namespace stemwise {
namespace {

/// Everything that `FrameFolder` may read.
bool is_of_frames(std::string_view name) { return name == "trajectory.txt" || name.starts_with("TreeManagerState_"); }

std::int64_t nanoseconds(const timespec& t) { return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec; }

void append(std::string& bytes, std::int64_t number) {
  std::array<char, sizeof number> raw{};
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = static_cast<char>(number >> 8 * i);
  bytes.append(raw.data(), raw.size());
}

}  // namespace

bool FolderStamp::is_settled(std::int64_t now_ns) const {
  constexpr std::int64_t coarsest_tick_ns = 2'000'000'000;  // of FAT; others have milliseconds
  return newest_ns + coarsest_tick_ns < now_ns;
}

std::optional<FolderStamp> frame_folder_stamp(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> open(::opendir(folder.c_str()), ::closedir);
  if (open == nullptr) return std::nullopt;
  std::vector<std::string> names;
  while (const dirent* entry = ::readdir(open.get())) {
    if (is_of_frames(entry->d_name)) names.emplace_back(entry->d_name);
  }
  std::sort(names.begin(), names.end());
  FolderStamp stamp;
  for (const std::string& name : names) {
    struct stat about {};
    const bool there = ::fstatat(::dirfd(open.get()), name.c_str(), &about, 0) == 0;
    stamp.bytes += name + '\0';
    if (!there) continue;  // a link to nothing: its name says enough
    const std::int64_t modified = nanoseconds(about.st_mtim), changed = nanoseconds(about.st_ctim);
    for (const std::int64_t n : {static_cast<std::int64_t>(about.st_dev), static_cast<std::int64_t>(about.st_ino),
                                 static_cast<std::int64_t>(about.st_size), modified, changed})
      append(stamp.bytes, n);
    stamp.newest_ns = std::max({stamp.newest_ns, modified, changed});
  }
  return stamp;
}

}  // namespace stemwise
