// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/available_disk.hpp"

#include "ionskin/base/byte_count.hpp"

#include <cstdlib>
#include <limits>
#include <system_error>

namespace ionskin::base {

AvailableDisk available_disk(const std::filesystem::path& folder) {
  if (const char* given = std::getenv("IONSKIN_DISK_LIMIT"); given != nullptr && *given != '\0') {
    return {static_cast<double>(byte_count("IONSKIN_DISK_LIMIT", given)),
            "allowed by IONSKIN_DISK_LIMIT"};
  }
  std::error_code error;
  std::filesystem::path place = std::filesystem::absolute(folder, error).lexically_normal();
  while (!std::filesystem::exists(place, error) && place.has_relative_path()) {
    place = place.parent_path();
  }
  const std::filesystem::space_info space = std::filesystem::space(place, error);
  // File systems such as /proc report no size; writing shows later whether they have room.
  const bool known = !error && space.capacity > 0;
  return {known ? static_cast<double>(space.available) : std::numeric_limits<double>::infinity(),
          "free below " + place.string()};
}

} // namespace ionskin::base
