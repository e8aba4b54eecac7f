// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <string>

namespace ionskin::apps {

/// Runs `ionskin sweep`: runs a sweep, or the part of it that the options name, and prints where
/// its results are.
/// @param command the command line, for the manifests
/// @return exit code: 0 when any point finished, with a line for the points that failed;
/// `solver_gave_up` when none did; `unfinished` when points are left or the report could not be
/// made
int sweep(const SweepOptions& options, const std::string& command);

} // namespace ionskin::apps
