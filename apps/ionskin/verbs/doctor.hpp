// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

/// Runs `ionskin doctor`: checks what ionskin needs of this machine and prints one line for each
/// item, with the remedy where it is missing.
/// @return exit code: 0 when everything needed is there, 2 otherwise
int doctor();

} // namespace ionskin::apps
