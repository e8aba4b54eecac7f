// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs `ionskin impedance`: writes the small-signal impedance spectrum of the cell of a case, with
/// its figures, and prints where it is.
/// @param command the command line, for the manifest
/// @return exit code
int impedance(const ImpedanceOptions& options, const std::string& command);

} // namespace ionskin::apps
