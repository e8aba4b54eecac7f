// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Writes the small-signal spectrum of a case's cell and says where it is.
/// @param command the command line, for the manifest
int impedance(const ImpedanceOptions& options, const std::string& command);

} // namespace ionskin::apps
