// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs a case and says where the results are.
/// @param command the command line, for the manifest
int run(const RunOptions& options, const std::string& command);

} // namespace ionskin::apps
