// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs `ionskin fit`: fits keys of a case to measured data and prints the estimates.
/// @param command the command line, for the manifest
/// @return exit code
int fit(const FitOptions& options, const std::string& command);

} // namespace ionskin::apps
