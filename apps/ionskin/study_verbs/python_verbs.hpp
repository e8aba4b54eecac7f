// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

// Verbs that ionskin's Python package answers. Their exit code is that of its script.

/// Draws the figures and the page of a run or a sweep.
int report(const ReportOptions& options);

/// Prints what differs between two runs.
int compare(const CompareOptions& options);

} // namespace ionskin::apps
