// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/edited_choice.hpp"
#include "ionskin/case/document/toml_walk.hpp"

#include <optional>
#include <string>

namespace ionskin {

/// Reports the keys that the case needs and does not have, and sets the others to their defaults.
/// Materials are left to `resolve_materials`.
/// @param file name of the case, for messages
/// @param choices that `--set` edits: what they ask for is reported as one problem
void complete(TomlWalk& walk, const std::string& file, const std::optional<EditedChoices>& choices,
              Problems& problems);

} // namespace ionskin
