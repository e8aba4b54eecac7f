// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::base {

/// Bytes that files in a folder may take, and the limit that bounds them, in words.
struct AvailableDisk {
  double bytes = 0;
  std::string bound; ///< "free below DIR"
};

/// Free disk space for this user in a folder, which need not exist yet; infinity where the system
/// does not tell. $IONSKIN_DISK_LIMIT, such as "300 GB", takes its place. Throws UserError when
/// that is not a number of bytes.
AvailableDisk available_disk(const std::filesystem::path& folder);

} // namespace ionskin::base
