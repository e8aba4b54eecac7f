// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <optional>

namespace ionskin::apps {

/// Parses the command line. Prints help, version or the error itself; then no command comes back
/// and `exit_code` is what the program must end with (0 for help, 2 for a wrong command line).
std::optional<Command> parse_command_line(int argc, char** argv, int& exit_code);

} // namespace ionskin::apps
