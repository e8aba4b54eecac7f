// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::apps {

struct CheckOptions {
  std::string case_path;
  std::vector<std::string> set_edits; ///< "key=value"
  bool explain = false;
};

/// Reads and checks a case and says that it is valid; explains it when asked. Throws UserError.
int check(const CheckOptions& options);

} // namespace ionskin::apps
