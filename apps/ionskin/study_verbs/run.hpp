// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs `ionskin run`: runs a case and prints where its results are.
/// @param command the command line, for the manifest
/// @return exit code
int run(const RunOptions& options, const std::string& command);

} // namespace ionskin::apps
