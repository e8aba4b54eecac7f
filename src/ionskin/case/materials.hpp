// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/toml_walk.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Names of the installed material presets: files NAME.toml in the folder `materials` of the data
/// folder.
std::vector<std::string> installed_materials();

/// Gives every layer its material: each value from the case, else from the installed preset of that
/// name. Unknown materials and missing values are collected; records of preset values are appended.
void resolve_materials(TomlWalk& walk, Problems& problems);

} // namespace ionskin
