// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

/// Checks what ionskin needs of this machine, one line each, with the remedy for what is missing.
/// @return exit code 0 when everything needed is there, 2 otherwise
int doctor();

} // namespace ionskin::apps
