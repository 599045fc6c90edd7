#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace stemwise::platform {

/// A lock on a file that ends with the process that holds it, however that ends: no number of a process that another one may
/// have by now. Others may read what stands in the file.
class FileLock {
 public:
  /// Makes the file where it is not there. Nothing when somebody holds it, another lock of this process too, or when there is no such folder.
  static std::optional<FileLock> take(const std::string& path);
  ~FileLock();  ///< lets go; the file goes with it
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  void write(std::string_view text);  ///< in the place of what stood there

 private:
  FileLock(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  void let_go();

  int descriptor_ = -1;
  std::string path_;
};

/// Somebody holds a FileLock on it just now, here or in another process.
bool is_locked(const std::string& path);

}  // namespace stemwise::platform
