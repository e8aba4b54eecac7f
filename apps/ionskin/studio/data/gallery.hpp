// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>

namespace ionskin::apps::studio {

/// The installed cases to start from: [{"id", "title", "summary", "text"}].
Json gallery();

/// Writes the files that a case of the gallery needs besides itself into the workspace, unless they
/// are there: the strain file. Throws HttpError 404, or 500 when they cannot be made.
void prepare(const Workspace& workspace, const std::string& id);

} // namespace ionskin::apps::studio
