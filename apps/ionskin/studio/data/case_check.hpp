// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <string>

namespace ionskin::apps::studio {

/// Checks the text of a case by `ionskin check --json` and returns its answer: {"valid": true,
/// "values", "explanation", "warning", "cost", ...}, or {"valid": false, "errors": [{"message",
/// "remedy", "line", "column", "length", "keys"}]}. The check runs in a separate process with
/// bounded time and memory. Files that the case names are looked for in the workspace; names of
/// files outside are errors.
Json check_case(const Workspace& workspace, const std::string& text);

/// Requires that the answer of `check_case` says that the case is valid. Throws HttpError 422 with
/// the first mistake.
void require_valid(const Json& verdict);

/// True if the value of a key of a case is the name of a file, such as that of a height map.
bool names_file(const std::string& key);

/// Splits the message of a UserError of `ionskin check` into its errors, as the array "errors" of
/// `check_case`: one entry for each problem.
Json split_errors(const std::string& text);

} // namespace ionskin::apps::studio
