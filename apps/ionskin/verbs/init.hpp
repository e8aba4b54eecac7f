// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

/// Options of `ionskin init`.
struct InitOptions {
  std::string path;            ///< file to write
  std::string from = "finger"; ///< name of a starter case
};

/// Runs `ionskin init`: writes a commented starter case and prints the next steps. Returns the exit
/// code 0. Throws UserError when the file exists or cannot be written.
int init(const InitOptions& options);

} // namespace ionskin::apps
