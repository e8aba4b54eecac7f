// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

/// Options of `ionskin keys`.
struct KeysOptions {
  bool json = false; ///< true to print JSON instead of text
  std::string word;  ///< only keys that contain it; empty for all
};

/// JSON array of all keys that a case may have, each with type, unit, range, default, choices, help
/// and source.
std::string keys_json();

/// Runs `ionskin keys`: prints the keys that a case may have with their meaning, choices and
/// defaults; as JSON also with unit, range and source. Returns the exit code 0. Throws UserError
/// when no key contains the word.
int keys(const KeysOptions& options);

} // namespace ionskin::apps
