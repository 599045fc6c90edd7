#pragma once
#include <atomic>
#include <string>
#include <vector>

namespace stemwise {

struct WindowOptions {
  std::vector<std::string> paths;  ///< a project, or inventories; may be empty
  // For scripts and tests:
  std::string ui_json;             ///< write the widgets' places here whenever they change, with window/inputs and window/settled to wait for
  std::string script;              ///< run these lines without a display instead (app/window/window_script.hpp)
  int width = 0, height = 0;       ///< 0: as remembered
};

/// The desktop window until it is closed. What the process exits with; messages go to stderr where no window can be made.
/// Once `interrupted` is set it ends as soon as unsaved work is in the autosave.
int run_window(const WindowOptions& options, const std::atomic<bool>& interrupted);

}  // namespace stemwise
