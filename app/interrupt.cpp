#include "app/interrupt.hpp"

#include <pthread.h>
#include <unistd.h>

#include "app/exit_code.hpp"

namespace stemwise {

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGUSR2);  // our own: "stop waiting"
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  waiter_ = std::thread([this] { wait_for_signals(); });
}

Interrupt::~Interrupt() {
  stopping_ = true;
  pthread_kill(waiter_.native_handle(), SIGUSR2);
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::wait_for_signals() {
  while (!stopping_) {
    int signal = 0;
    if (sigwait(&signals_, &signal) != 0 || signal == SIGUSR2) continue;
    if (requested_.exchange(true)) _exit(static_cast<int>(ExitCode::interrupted));
  }
}

}  // namespace stemwise
