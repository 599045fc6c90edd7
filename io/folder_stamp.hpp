#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace stemwise {

/// What tells one state of a frame folder from any other without opening a file: name, size, inode, times of the last change of
/// content and of anything, of the trajectory and of every frame file.
struct FolderStamp {
  std::string bytes;
  std::int64_t newest_ns = 0;  ///< the latest of all times, since 1970

  bool operator==(const FolderStamp&) const = default;
  /// Every change from `now_ns` on will show in a stamp. Not so just after a change: a second one in the same tick of the file
  /// system's clock has the same time. Nor where the times lie in the future.
  bool is_settled(std::int64_t now_ns) const;
};

/// Nothing where there is no such folder.
std::optional<FolderStamp> frame_folder_stamp(const std::string& folder);

}  // namespace stemwise
