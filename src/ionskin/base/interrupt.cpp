// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/interrupt.hpp"

#include "ionskin/base/error.hpp"

#include <csignal>

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

} // namespace

void install_interrupt_handler() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
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
