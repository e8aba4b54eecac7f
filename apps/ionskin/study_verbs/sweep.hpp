// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs a sweep and says where its results are. Exit code 0 when any point finished, with a line
/// for those that failed; `solver_gave_up` when none did.
/// @param command the command line, for the manifests
int sweep(const SweepOptions& options, const std::string& command);

} // namespace ionskin::apps
