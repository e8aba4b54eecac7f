// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>

namespace ionskin::apps::studio {

/// Answer of `ionskin check --json` on a case: {"valid": true, "values", "explanation", "warning",
/// "cost"}, or
/// {"valid": false, "errors": [{"message", "remedy", "line", "column", "length", "keys"}]}. The
/// check runs in a process of its own, with bounded time and memory. Files that the case names are
/// looked for in the workspace; others are errors.
Json check_case(const Workspace& workspace, const std::string& text);

/// Throws HttpError 422 with the first mistake of a case that `check_case` refused.
void require_valid(const Json& verdict);

/// True if the value of a key of a case is the name of a file.
bool names_file(const std::string& key);

/// The errors in the text of a UserError: one entry per problem.
Json split_errors(const std::string& text);

} // namespace ionskin::apps::studio
