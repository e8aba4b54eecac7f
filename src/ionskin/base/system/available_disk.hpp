// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::base {

/// Disk space available to files in a folder, and what limits it.
struct AvailableDisk {
  double bytes = 0;
  std::string bound; ///< description of the limit, for messages: "free below DIR"
};

/// Finds the free disk space for this user below a folder, which need not exist yet; infinity if
/// the system does not report it. The environment variable IONSKIN_DISK_LIMIT, such as "300 GB",
/// replaces the value. Throws UserError when the variable is not a size.
AvailableDisk available_disk(const std::filesystem::path& folder);

} // namespace ionskin::base
