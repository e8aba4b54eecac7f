// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>

namespace ionskin::apps::studio {

/// Lists the installed cases to start from, as an array [{"id", "title", "summary", "text"}] with
/// the text of each case file.
Json gallery();

/// Writes the files that a case of the gallery names, such as its strain file, into the workspace,
/// unless they exist. Throws HttpError 404 when there is no such case, 500 when a file cannot be
/// made.
void prepare(const Workspace& workspace, const std::string& id);

} // namespace ionskin::apps::studio
