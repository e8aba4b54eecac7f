// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

// Verbs that ionskin's Python package answers. Their exit code is that of its script.

/// Runs `ionskin report`: makes the page of a run or a sweep, and its figures. Returns the exit
/// code of the Python script.
int report(const ReportOptions& options);

/// Runs `ionskin compare`: prints the differences of two runs. Returns the exit code of the Python
/// script.
int compare(const CompareOptions& options);

/// Runs `ionskin cluster`: starts or stops a cluster, or adds a worker to it. The Python script
/// replaces this process, so that the function returns only by an exception.
int cluster(const ClusterOptions& options);

/// Runs batches of the sweep that is planned in the output folder on a cluster, and waits for them.
/// @param batches numbers of the batches
/// @param progress form of the progress on stderr: "bar", "lines", "json" or "none"
/// @return 0, or the exit code with which the program must end
int do_batches_on_cluster(const SweepOptions& options, const std::vector<std::size_t>& batches,
                          const std::string& progress);

} // namespace ionskin::apps
