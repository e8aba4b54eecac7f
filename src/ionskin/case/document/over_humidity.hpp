// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/toml_walk.hpp"

#include <string>

namespace ionskin {

/// Chooses the numbers that a material gives as lists over its humidities: linear between them, at
/// skin.humidity. Their records and the draft hold one number afterwards. Lists that do not fit, a
/// missing humidity and one beyond the list are collected.
/// @return whether the material has such lists
bool settle_humidity(const std::string& material, TomlWalk& walk, Problems& problems);

/// Collects a skin.humidity that no material follows.
void refuse_humidity(const TomlWalk& walk, Problems& problems);

} // namespace ionskin
