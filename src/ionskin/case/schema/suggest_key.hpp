// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// Finds the key of a case that a user probably meant by a word that is no key: the key with this
/// symbol in docs/model.md, such as k; a key of similar spelling; or a key whose last name is
/// similar. Empty if there is none. Dashes count as underscores.
std::string suggest_key(const std::string& word);

} // namespace ionskin
