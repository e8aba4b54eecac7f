// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace ionskin::base {

/// Turns SIGINT and SIGTERM into a request that `check_interrupt` honours. A second signal ends the
/// process at once.
void install_interrupt_handler();

/// Asks to stop, as a signal does.
void request_interrupt();

/// Interrupt handler for a host with signal handlers of its own: while this lives, SIGINT is a
/// request to stop; then the host's handler is back and the request is forgotten. One at a time.
class InterruptScope {
public:
  /// @param take_signal false leaves SIGINT to the host; `request_interrupt` still counts
  explicit InterruptScope(bool take_signal);
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

private:
  bool taken_;
  struct sigaction former_ {};
};

/// True once the user has asked to stop.
bool interrupt_requested();

/// Call between units of work. Throws `Interrupted` once the user has asked to stop.
void check_interrupt();

} // namespace ionskin::base
