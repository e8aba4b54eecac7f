// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace ionskin::results {

/// Message that a file lacks an object, with the remedy.
inline std::string missing_object(const std::filesystem::path& path, const std::string& object) {
  return fmt::format(
      "{} has no {}\n  = check that the file is complete and of the documented layout",
      path.string(), object);
}

/// Message that an object of a file cannot be read, with the remedy.
inline std::string read_failure(const std::filesystem::path& path, const std::string& object) {
  return fmt::format("{} of {} cannot be read\n  = the file is damaged or {} is not of the "
                     "documented type: write it again",
                     object, path.string(), object);
}

/// Message that an object cannot be written to a file, with the remedy.
inline std::string write_failure(const std::filesystem::path& path, const std::string& object) {
  return fmt::format("{} cannot be written to {}\n  = check the free space and the permissions of "
                     "the folder, or choose another with -o",
                     object, path.string());
}

} // namespace ionskin::results
