// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/edited_choice.hpp"
#include "ionskin/case/document/toml_walk.hpp"

#include <optional>
#include <string>

namespace ionskin {

/// Sets every missing key that has a default and applies to the case to its default, and reports
/// the missing keys that the case needs. Keys of materials are left to `resolve_materials`.
/// @param walk the case as read; its draft and records are completed
/// @param file name of the case, for messages
/// @param choices choices that `--set` edits change: keys needed because of them are one mistake
/// @param problems collects the missing keys
void complete(TomlWalk& walk, const std::string& file, const std::optional<EditedChoices>& choices,
              Problems& problems);

} // namespace ionskin
