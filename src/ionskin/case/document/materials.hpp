// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/toml_walk.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Names of the installed material presets: files NAME.toml in the folder `materials` of the data
/// folder.
std::vector<std::string> installed_materials();

/// Completes the materials of the layers from the installed presets of their names, and the ions
/// from the material of the core: whatever the case does not give itself. Records are appended.
void complete_materials(TomlWalk& walk, Problems& problems);

/// Gives every layer whose stiffness the case needs its material: all of them with contact, the
/// core where water moves through it. Unknown materials and missing values are collected.
void resolve_materials(TomlWalk& walk, Problems& problems);

} // namespace ionskin
