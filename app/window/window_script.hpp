#pragma once
#include "app/window/run_window.hpp"

namespace stemwise {

/// Drives the window without a display by lines of a file, for screenshots of the guide and the README:
///   size 1600 1000 | theme dark | click review/accept | key N | type TEXT | fill export/path TEXT | move X Y | drag X Y X Y | wheel X Y NOTCHES | settle | wait SECONDS |
///   click-at X Y | double-click PATH | do ACTION | screenshot FILE.png | widgets FILE.json
/// A first line "config FOLDER" lets it remember and save by itself there, as a window does; without it nothing is kept.
/// Stops at the first line that cannot be done (exit code 1).
int run_window_script(const WindowOptions& options);

}  // namespace stemwise
