// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct InitOptions {
  std::string path;            ///< file to write
  std::string from = "finger"; ///< name of a starter case
};

/// Writes a commented starter case and says what to do next. Never overwrites. Throws UserError.
int init(const InitOptions& options);

} // namespace ionskin::apps
