#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace stemwise {

struct WindowModel;

/// Where an autosave came from.
struct AutosaveOrigin {
  std::string path;   ///< the person's file; empty when never saved
  std::string title;
  std::string time;   ///< of the last autosave, for people
  int process = 0;    ///< that wrote it
};

/// Keeps a copy of the project after every edit, in a file of its own beside the settings: a crash or a power cut loses
/// nothing. Written on its own thread; the person's file is never touched.
class Autosave {
 public:
  explicit Autosave(std::string folder);
  /// Starts writing when there is something new and nothing is being written.
  void tend(WindowModel& model);
  /// The work is in the person's file, or given up: the copy can go.
  void forget();

 private:
  std::string file_;
  std::uint64_t kept_ = 0;  ///< revision that is in the file, 0: none
};

/// Autosaves in the folder whose program does not run any more, newest first.
std::vector<std::string> orphaned_autosaves(const std::string& folder);
AutosaveOrigin autosave_origin(const std::string& file);
void discard_autosave(const std::string& file);

}  // namespace stemwise
