// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <optional>

namespace ionskin::apps {

/// Parses the command line of `ionskin`. Prints help, the version or the error where there is no
/// command to run.
/// @param exit_code set, where nullopt is returned, to the code with which the program must end: 0
/// after help and version, 2 for a wrong command line
/// @return options of the verb to run; nullopt when there is none
std::optional<Command> parse_command_line(int argc, char** argv, int& exit_code);

} // namespace ionskin::apps
