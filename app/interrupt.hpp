#pragma once
#include <atomic>
#include <csignal>
#include <thread>

namespace stemwise {

/// Turns Ctrl+C and SIGTERM into a flag that jobs look at, for as long as it lives; a second Ctrl+C ends the process at
/// once. A thread of its own waits for the signals, so that no handler and no global is needed. Make it before any other
/// thread: threads inherit the blocked signals.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  const std::atomic<bool>& requested() const { return requested_; }

 private:
  void wait_for_signals();

  std::atomic<bool> requested_{false};
  std::atomic<bool> stopping_{false};
  sigset_t signals_{};
  sigset_t before_{};
  std::thread waiter_;
};

}  // namespace stemwise
