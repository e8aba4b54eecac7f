// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/toml_walk.hpp"

#include <string>

namespace ionskin {

/// Resolves the constants that a material gives as lists over its humidities, by linear
/// interpolation at skin.humidity. Afterwards their records and the draft in `walk` hold single
/// numbers.
/// @param material name of the material
/// @param problems collects lists of a wrong length, and a humidity that is missing or out of range
/// @return true if the material has such lists
bool settle_humidity(const std::string& material, TomlWalk& walk, Problems& problems);

/// Reports a given skin.humidity as a mistake. Called when no material of the skin depends on it.
void refuse_humidity(const TomlWalk& walk, Problems& problems);

} // namespace ionskin
