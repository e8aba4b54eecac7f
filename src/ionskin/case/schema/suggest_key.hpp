// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// The key that was probably meant by a word that is none: one whose last name it is or nearly is,
/// one that is spelt nearly so, or the one with this symbol in the pages, such as k. Empty when
/// there is none. Dashes count as underscores.
std::string suggest_key(const std::string& word);

} // namespace ionskin
