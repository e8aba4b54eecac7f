// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct KeysOptions {
  bool json = false;
  std::string word; ///< only keys that contain it; empty for all
};

/// Prints every key of a case: what it is, its choices and default; as JSON also unit, range and
/// source. Throws UserError when no key contains the word.
int keys(const KeysOptions& options);

} // namespace ionskin::apps
