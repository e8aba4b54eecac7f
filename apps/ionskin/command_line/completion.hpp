// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct CompletionOptions {
  std::string shell; ///< "bash" or "zsh"
};

/// Prints the script that lets the shell complete verbs, options, choices, files and case keys.
int completion(const CompletionOptions& options);

} // namespace ionskin::apps
