// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

/// Prints the manual page (roff): `ionskin man | man -l -`.
int manual_page();

} // namespace ionskin::apps
