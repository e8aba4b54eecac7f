// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

/// Runs `ionskin man`: prints the manual page in roff, to be read by `ionskin man | man -l -`.
/// Returns the exit code 0.
int manual_page();

} // namespace ionskin::apps
