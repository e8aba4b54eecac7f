// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

/// Options of `ionskin completion`.
struct CompletionOptions {
  std::string shell; ///< "bash" or "zsh"
};

/// Runs `ionskin completion`: prints a script for the shell's completion of verbs, options,
/// choices, files and keys of a case. Returns the exit code 0.
int completion(const CompletionOptions& options);

} // namespace ionskin::apps
