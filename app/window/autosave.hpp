#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "app/platform/file_lock.hpp"

namespace stemwise {

struct WindowModel;

/// Where an autosave came from.
struct AutosaveOrigin {
  std::string path;   ///< the person's file; empty when never saved
  std::string title;
  std::string time;   ///< of the last autosave, for people
  std::string stamp;  ///< what that file held when it was read or written last
};

/// An autosave whose window has ended without a word. While this is held no other window offers it.
struct Leftover {
  std::string file;
  AutosaveOrigin origin;
  platform::FileLock lock;
};

/// Keeps a copy of the project after every edit, in a file of its own beside the settings: a crash or a power cut loses
/// nothing. Written on its own thread; the person's file is never touched. A lock beside it lives as long as this window, and
/// holds the path of the project that is open in it.
class Autosave {
 public:
  explicit Autosave(const std::string& folder);
  /// Starts writing when there is something new and nothing is being written.
  void tend(WindowModel& model);
  /// The work is in the person's file, or given up: the copy can go, and with it what it was brought back from.
  void forget(WindowModel& model);
  const std::string& file() const { return file_; }

 private:
  void tell_others(const std::string& path);

  std::string file_;
  std::optional<platform::FileLock> lock_;
  std::string told_;        ///< path that stands in the lock
  std::uint64_t kept_ = 0;  ///< revision that is in the file, 0: none
};

/// The newest autosave in the folder whose window does not live any more; `of`: only of the project in this file.
std::optional<Leftover> take_leftover(const std::string& folder, const std::string& of = {});
/// Another window than the one with this autosave has the project in this file open.
bool is_open_elsewhere(const std::string& own_autosave, const std::string& path);
void discard(std::optional<Leftover>& leftover);

}  // namespace stemwise
