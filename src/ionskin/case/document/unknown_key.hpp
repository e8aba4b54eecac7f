// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// Finds the key that a user probably meant by an unknown key; empty if there is none.
/// @param key full name of the unknown key in the case: "skin.layers[1].thicknes"
/// @param pattern the key with the wildcards of the schema: "skin.layers[].thicknes"
std::string meant_key(const std::string& key, const std::string& pattern);

/// Lists the keys that the schema has in the table of a key, for a message: "keys of TABLE: ...".
/// @param key, pattern as of `meant_key`
std::string list_of_siblings(const std::string& key, const std::string& pattern);

} // namespace ionskin
