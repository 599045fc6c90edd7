#pragma once
#include <mutex>
#include <string>

#include "core/base/issue.hpp"
#include "core/jobs/progress.hpp"

namespace stemwise {

/// Everything a person reads: on stderr, so that stdout holds nothing but results. Callable from any thread.
class Console {
 public:
  /// `quiet`: errors only. A bar on a terminal, plain lines otherwise.
  explicit Console(bool quiet);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void say(const std::string& line);
  void warn(const std::string& line);
  void error(const std::string& line);
  /// All of them, each with its place; notes only when not quiet. Beyond `most` of one file the rest is counted.
  void issues(const Issues& issues, std::size_t most = 50);
  /// Reports here and obeys `cancel`.
  Progress progress(const std::atomic<bool>* cancel);
  /// Takes the bar off the screen; called before any other output.
  void end_progress();

 private:
  void write_line(const std::string& line);
  void clear_bar();
  void show_progress(double fraction, const std::string& text);

  std::mutex mutex_;
  bool quiet_ = false;
  bool terminal_ = false;
  bool bar_shown_ = false;
  int last_step_ = -1;
  std::string last_text_;
};

}  // namespace stemwise
