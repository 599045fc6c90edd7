#include "app/console.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace stemwise {
namespace {

constexpr int bar_cells = 30;

std::string bar_of(double fraction, const std::string& text) {
  const int full = std::clamp(static_cast<int>(std::lround(fraction * bar_cells)), 0, bar_cells);
  const int percent = std::clamp(static_cast<int>(std::floor(fraction * 100.0 + 1e-9)), 0, 100);
  char number[16];
  std::snprintf(number, sizeof number, "%3d %%", percent);
  return "[" + std::string(full, '#') + std::string(bar_cells - full, '-') + "] " + number + "  " + text.substr(0, 60);
}

const char* word_of(Severity severity) {
  switch (severity) {
    case Severity::note: return "note: ";
    case Severity::warning: return "warning: ";
    case Severity::error: return "error: ";
  }
  return "";
}

}  // namespace

Console::Console(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}
Console::~Console() { end_progress(); }

void Console::say(const std::string& line) {
  if (!quiet_) write_line(line);
}
void Console::warn(const std::string& line) {
  if (!quiet_) write_line("warning: " + line);
}
void Console::error(const std::string& line) { write_line("error: " + line); }

void Console::issues(const Issues& issues, std::size_t most) {
  std::map<std::pair<std::string, Severity>, std::size_t> shown;
  std::map<std::pair<std::string, Severity>, std::size_t> left;
  for (const Issue& issue : issues) {
    if (quiet_ && issue.severity != Severity::error) continue;
    const std::pair key{issue.file, issue.severity};
    if (shown[key]++ < most) {
      write_line(word_of(issue.severity) + to_string(issue));
    } else {
      ++left[key];
    }
  }
  for (const auto& [key, count] : left) {
    write_line(word_of(key.second) + key.first + ": " + std::to_string(count) + " more like these (all of them: stemwise info --json -)");
  }
}

Progress Console::progress(const std::atomic<bool>* cancel) {
  if (quiet_) return Progress({}, cancel);
  return Progress([this](double fraction, const std::string& text) { show_progress(fraction, text); }, cancel);
}

void Console::end_progress() {
  const std::scoped_lock lock(mutex_);
  clear_bar();
  last_step_ = -1;
  last_text_.clear();
}

void Console::write_line(const std::string& line) {
  const std::scoped_lock lock(mutex_);
  clear_bar();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Console::clear_bar() {
  if (!bar_shown_) return;
  std::fputs("\r\033[K", stderr);
  bar_shown_ = false;
}

void Console::show_progress(double fraction, const std::string& text) {
  const std::scoped_lock lock(mutex_);
  const int step = static_cast<int>(std::floor(fraction * (terminal_ ? 200.0 : 4.0)));
  if (step == last_step_ && text == last_text_) return;
  if (!terminal_ && text == last_text_ && step <= last_step_) return;
  last_step_ = step;
  last_text_ = text;
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s", bar_of(fraction, text).c_str());
    std::fflush(stderr);
    bar_shown_ = true;
  } else {
    std::fprintf(stderr, "%3d %%  %s\n", static_cast<int>(std::floor(fraction * 100.0)), text.c_str());
  }
}

}  // namespace stemwise
