// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/toml_walk.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Lists the names of the installed material presets, sorted: files NAME.toml in the folder
/// `materials` of `data_folder`.
std::vector<std::string> installed_materials();

/// Fills in what the case does not give itself: properties of the layers' materials, from the
/// installed presets of the same names, and properties of ions and water, from the material of the
/// core. Appends their records to `walk`, and resolves lists over humidity (`settle_humidity`).
/// @param problems collects mistakes
void complete_materials(TomlWalk& walk, Problems& problems);

/// Sets `Layer::material` of every layer whose stiffness the case needs: of all layers with
/// contact, else of the core, if the coupling law moves water.
/// @param problems collects unknown materials and missing elastic constants
void resolve_materials(TomlWalk& walk, Problems& problems);

} // namespace ionskin
