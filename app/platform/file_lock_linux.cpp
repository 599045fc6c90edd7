#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "app/platform/file_lock.hpp"

namespace stemwise::platform {
namespace {

/// The file that was locked still has this name: another one may have let it go, and its name with it, in between.
bool has_name(int descriptor, const std::string& path) {
  struct stat held {}, named {};
  return fstat(descriptor, &held) == 0 && stat(path.c_str(), &named) == 0 && held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

/// Where a file system knows no locks nobody holds one: better a work offered twice than never.
bool lock_now(int descriptor, int kind) { return flock(descriptor, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

}  // namespace

std::optional<FileLock> FileLock::take(const std::string& path) {
  while (true) {
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0) return std::nullopt;
    const bool locked = lock_now(descriptor, LOCK_EX);
    if (locked && has_name(descriptor, path)) return FileLock(descriptor, path);
    close(descriptor);
    if (!locked) return std::nullopt;
  }
}

FileLock::~FileLock() { let_go(); }

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  if (this == &other) return *this;
  let_go();
  descriptor_ = std::exchange(other.descriptor_, -1);
  path_ = std::move(other.path_);
  return *this;
}

void FileLock::let_go() {
  if (descriptor_ < 0) return;
  unlink(path_.c_str());  // before the lock goes: nobody else can have taken this very file
  close(std::exchange(descriptor_, -1));
}

void FileLock::write(std::string_view text) {
  if (ftruncate(descriptor_, 0) != 0) return;
  for (off_t at = 0; !text.empty();) {
    const ssize_t written = pwrite(descriptor_, text.data(), text.size(), at);
    if (written <= 0) return;  // only a word for other windows
    at += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_locked(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool held = !lock_now(descriptor, LOCK_SH);
  close(descriptor);
  return held;
}

}  // namespace stemwise::platform
