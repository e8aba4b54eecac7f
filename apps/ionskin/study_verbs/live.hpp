// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Trains the reduced skin of a case, writes its file and says how far it is from the full model.
/// @param command the command line, for the record
int live(const LiveOptions& options, const std::string& command);

} // namespace ionskin::apps
