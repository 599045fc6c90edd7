#include "io/replace_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>

namespace stemwise {
namespace {

namespace fs = std::filesystem;

Result<Done> failed(const std::string& path, const std::string& why) { return Result<Done>::failure(cannot_write(path, why)); }

/// Errno of flushing a file or folder to the disk, 0 when it went well.
int flush(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return error;
}

/// Holds a file that is about to be replaced, against others who do the same.
class Hold {
 public:
  explicit Hold(const std::string& path) {
    while ((descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) >= 0) {
      is_taken_ = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;  // where there are no locks the look has to do
      struct stat held {}, named {};
      if (is_taken_ || ::fstat(descriptor_, &held) != 0 || ::stat(path.c_str(), &named) != 0) return;
      if (held.st_dev == named.st_dev && held.st_ino == named.st_ino) return;
      ::close(descriptor_);  // it was replaced in between
    }
  }
  ~Hold() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;
  bool is_taken() const { return is_taken_; }

 private:
  int descriptor_ = -1;
  bool is_taken_ = false;
};

/// A link stays one: the file that it names is written.
std::string target_of(const std::string& path) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : fs::path(path);
  return target.empty() ? path : target.string();
}

}  // namespace

Issue cannot_write(const std::string& path, const std::string& why) {
  std::error_code error;
  const fs::path folder = fs::absolute(path, error).parent_path();
  if (!fs::exists(folder, error) && !error) return {Severity::error, path, 0, {}, "cannot be written: the folder " + folder.string() + " is not there", "make it, or choose another folder"};
  return {Severity::error, path, 0, {}, "cannot be written" + (why.empty() ? "" : ": " + why), "check the folder, its rights and the space left"};
}

std::string temporary_beside(const std::string& path) {
  const fs::path p = target_of(path);
  return (p.parent_path() / ("." + p.stem().string() + ".writing-" + std::to_string(::getpid()) + p.extension().string())).string();
}

Result<Done> replace_file(const std::string& temporary, const std::string& given) {
  std::error_code ignored;
  const std::string path = target_of(given);
  const auto give_up = [&](const std::string& why) {
    fs::remove(temporary, ignored);
    return failed(path, why);
  };
  if (const int error = flush(temporary, O_RDONLY); error != 0) return give_up(std::strerror(error));
  if (fs::is_directory(path, ignored)) return give_up("a folder of that name is there");
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return give_up("it is a device or a pipe, not a file");  // never renamed over
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) return give_up(error.message());
  const fs::path folder = fs::path(path).parent_path();
  flush(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);  // where a folder cannot be flushed the rename still holds
  return Done{};
}

Result<Done> replace_file(const std::string& temporary, const std::string& path, const std::function<Result<Done>()>& look) {
  const Hold hold(path);
  Result<Done> agreed = hold.is_taken() ? failed(path, "another program is writing it just now") : look();
  if (agreed) return replace_file(temporary, path);
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return agreed;
}

namespace {

/// Writes all of the text and closes. Errno, 0 when it went well.
int write_all(int descriptor, std::string_view text, bool is_file) {
  int error = 0;
  while (!text.empty() && error == 0) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR) error = errno;
  }
  if (error == 0 && is_file && ::fsync(descriptor) != 0) error = errno;  // some file systems tell only now that they are full
  ::close(descriptor);
  return error;
}

/// A device or a pipe: written into, never replaced.
Result<Done> write_stream(const std::string& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return failed(path, std::strerror(errno));
  const int error = write_all(descriptor, text, false);
  return error == 0 ? Result<Done>(Done{}) : failed(path, std::strerror(error));
}

}  // namespace

Result<Done> write_temporary(const std::string& path, std::string_view text) {
  const std::string temporary = temporary_beside(path);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return failed(path, std::strerror(errno));
  const int error = write_all(descriptor, text, true);
  if (error == 0) return Done{};
  ::unlink(temporary.c_str());
  return failed(path, std::strerror(error));
}

Result<Done> write_text_file(const std::string& path, std::string_view text) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored)) return write_stream(path, text);
  if (Result<Done> done = write_temporary(path, text); !done) return done;
  return replace_file(temporary_beside(path), path);
}

long long timestamp_s() {
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH"); fixed != nullptr && *fixed != '\0') return std::atoll(fixed);
  return static_cast<long long>(std::time(nullptr));
}

std::string timestamp_utc() {
  const std::time_t seconds = static_cast<std::time_t>(timestamp_s());
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 40> buffer{};
  std::strftime(buffer.data(), buffer.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return buffer.data();
}

std::string timestamp_utc_ms() {
  std::string text = timestamp_utc();
  return text.replace(text.size() - 1, 1, ".000Z");
}

}  // namespace stemwise
