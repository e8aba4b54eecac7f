// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// The key that was probably meant by one that the schema lacks, or an empty string.
/// @param key as it stands in the case
/// @param pattern its names as the schema would write them
std::string meant_key(const std::string& key, const std::string& pattern);

/// List of the keys that could stand beside it, for a message: "keys of TABLE: ...".
std::string list_of_siblings(const std::string& key, const std::string& pattern);

} // namespace ionskin
