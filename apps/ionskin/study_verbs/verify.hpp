// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

/// Runs the verification set, prints one row for each figure and a line of totals. Exit code 0 only
/// if all pass.
int verify(const VerifyOptions& options);

} // namespace ionskin::apps
