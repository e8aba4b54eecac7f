// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

// Verbs that ionskin's Python package answers. Their exit code is that of its script.

/// Draws the figures and the page of a run or a sweep.
int report(const ReportOptions& options);

/// Prints what differs between two runs.
int compare(const CompareOptions& options);

/// Starts or stops a cluster, or works for one: this process becomes the worker.
int cluster(const ClusterOptions& options);

/// Hands batches of the plan in the output folder to a cluster, and waits for them.
/// @param progress "bar", "lines", "json" or "none"
/// @return 0, or the exit code that the program shall end with
int do_batches_on_cluster(const SweepOptions& options, const std::vector<std::size_t>& batches,
                          const std::string& progress);

} // namespace ionskin::apps
