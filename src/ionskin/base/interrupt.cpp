// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/interrupt.hpp"

#include "ionskin/base/error.hpp"
namespace ionskin::base {
namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void on_signal(int signal_number) {
  if (requested) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
  }
  requested = 1;
}

extern "C" void on_signal_to_host(int) {
  requested = 1;
}

} // namespace

void install_interrupt_handler() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

void request_interrupt() {
  requested = 1;
}

InterruptScope::InterruptScope(bool take_signal) : taken_(take_signal) {
  requested = 0;
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
  requested = 0;
}

bool interrupt_requested() {
  return requested != 0;
}

void check_interrupt() {
  if (interrupt_requested()) {
    throw Interrupted();
  }
}

} // namespace ionskin::base
