// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Names of the tables that a folder of results may hold as NAME.csv; those that end in `_error`
/// hold half the widths of the error bands of the others, row by row.
const std::vector<std::string>& known_tables();

/// Kind of the results of a folder: "run", "sweep", "fit", or "" for no results of ionskin.
std::string result_kind(const base::FileDescriptor& folder);

/// Every folder of results in the workspace, the newest first: {"path", "kind", "title", "state",
/// "started", "command", "warnings", "metrics"}. Links are not followed; points of sweeps belong to
/// their sweep. Where a file of a folder is damaged, its state is "damaged", and a warning tells
/// why.
Json list_results(const Workspace& workspace);

/// Everything about one folder that is small: as in the list, with all metrics, error estimates,
/// timing, the case's text, names of tables; points of a sweep, parameters of a fit.
/// Throws HttpError 404 when it holds no results.
Json describe_result(const Opened& folder);

} // namespace ionskin::apps::studio
