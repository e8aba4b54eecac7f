// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Names of the tables that a folder of results may hold as NAME.csv. A table whose name ends in
/// `_error` holds, row by row, half the widths of the error bands of the table without this ending.
const std::vector<std::string>& known_tables();

/// Kind of the results of a folder: "run", "sweep", "fit", or "" for no results of ionskin.
std::string result_kind(const base::FileDescriptor& folder);

/// Lists the folders of results in the workspace, the newest first, as an array of {"path", "kind",
/// "title", "state", "started", "command", "warnings", "metrics"}. Links are not followed; the
/// points of a sweep are not listed by themselves. Where a file of a folder is damaged, its state
/// is "damaged", and a warning says why.
Json list_results(const Workspace& workspace);

/// Describes one folder of results: its entry in `list_results`, with all metrics, error estimates,
/// timing, the text of the case and the names of its tables; for a sweep its points, for a fit its
/// parameters. Tables and fields are requested separately.
/// Throws HttpError 404 when the folder holds no results.
Json describe_result(const Opened& folder);

} // namespace ionskin::apps::studio
