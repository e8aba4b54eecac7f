// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace ionskin::base {

/// Installs a handler that turns SIGINT, SIGTERM and SIGHUP (unless ignored, as by nohup) into a
/// request to stop, which `check_interrupt` acts on. A second signal ends the process at once.
void install_interrupt_handler();

/// Requests to stop, as a signal does.
void request_interrupt();

/// Guard that handles SIGINT in a host program with signal handlers of its own, such as Python.
/// While it lives, SIGINT is a request to stop; its destructor restores the host's handler and
/// clears the request. Only one may live at a time.
class InterruptScope {
public:
  /// Clears an earlier request and installs the handler.
  /// @param take_signal false to leave SIGINT to the host; `request_interrupt` still works
  explicit InterruptScope(bool take_signal);
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

private:
  bool taken_;
  struct sigaction former_ {};
};

/// True if a stop has been requested.
bool interrupt_requested();

/// Throws `Interrupted` if a stop has been requested. Solvers call it between units of work.
void check_interrupt();

} // namespace ionskin::base
