// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::base {

/// Turns SIGINT and SIGTERM into a request that `check_interrupt` honours. A second signal ends the
/// process at once.
void install_interrupt_handler();

/// True once the user has asked to stop.
bool interrupt_requested();

/// Call between units of work. Throws `Interrupted` once the user has asked to stop.
void check_interrupt();

} // namespace ionskin::base
