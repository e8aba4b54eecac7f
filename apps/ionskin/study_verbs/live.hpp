// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs `ionskin live`: trains the reduced-order skin of a case, writes its file, or an FMU of it,
/// and prints its errors against the full model.
/// @param command the command line, which is recorded in the file
/// @return exit code
int live(const LiveOptions& options, const std::string& command);

} // namespace ionskin::apps
