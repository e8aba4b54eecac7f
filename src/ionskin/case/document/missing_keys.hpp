// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/toml_walk.hpp"

#include <string>

namespace ionskin {

/// Reports the keys that the case needs and does not have, and sets the others to their defaults.
/// Materials are left to `resolve_materials`.
/// @param file name of the case, for messages
void complete(TomlWalk& walk, const std::string& file, Problems& problems);

} // namespace ionskin
