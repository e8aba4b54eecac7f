// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct KeysOptions {
  bool json = false;
  std::string word; ///< only keys that contain it; empty for all
};

/// Every key of a case as a JSON array: type, unit, range, default, choices, help and source.
std::string keys_json();

/// Prints every key of a case: what it is, its choices and default; as JSON also unit, range and
/// source. Throws UserError when no key contains the word.
int keys(const KeysOptions& options);

} // namespace ionskin::apps
