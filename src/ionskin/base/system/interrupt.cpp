// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/interrupt.hpp"

#include "ionskin/base/error.hpp"

#include <atomic>

namespace ionskin::base {
namespace {

// Request to stop: set by a signal handler or a thread, read by all threads.
std::atomic<int> requested{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void on_signal(int signal_number) {
  if (requested) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
  }
  requested = true;
}

extern "C" void on_signal_to_host(int) {
  requested = true;
}

} // namespace

void install_interrupt_handler() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // SIGHUP: the terminal is gone. It stays ignored under nohup, so that the run continues.
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) {
    std::signal(SIGHUP, SIG_IGN);
  }
}

void request_interrupt() {
  requested = true;
}

InterruptScope::InterruptScope(bool take_signal) : taken_(take_signal) {
  requested = false;
  if (taken_) {
    struct sigaction ours {};
    ours.sa_handler = on_signal_to_host;
    sigemptyset(&ours.sa_mask);
    sigaction(SIGINT, &ours, &former_);
  }
}

InterruptScope::~InterruptScope() {
  if (taken_) {
    sigaction(SIGINT, &former_, nullptr);
  }
  requested = false;
}

bool interrupt_requested() {
  return requested;
}

void check_interrupt() {
  if (interrupt_requested()) {
    throw Interrupted();
  }
}

} // namespace ionskin::base
