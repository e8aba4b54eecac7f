// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

/// Runs `ionskin verify`: compares the solvers with reference solutions, prints one row for each
/// verified figure and a line of totals. Returns the exit code 0 only if all figures pass.
int verify(const VerifyOptions& options);

} // namespace ionskin::apps
