#pragma once
#include <filesystem>
#include <string>

namespace stemwise {

struct WindowModel;

/// Looks now and then whether the project's file still holds what this window knows of it, and says so when it does not.
class FileWatch {
 public:
  /// Every frame; costs nothing while the file is as it was looked at last.
  void tend(WindowModel& model, double elapsed_s);

 private:
  double waited_s_ = 0.0;
  std::string path_;
  std::filesystem::file_time_type seen_;
};

/// The project's file is known to hold something else than what was read from it or written to it here.
bool is_changed_elsewhere(const WindowModel& model);

}  // namespace stemwise
