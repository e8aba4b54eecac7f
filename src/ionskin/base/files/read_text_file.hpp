// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <cstddef>
#include <string>

namespace ionskin::base {

/// Most bytes of a table of numbers: height map, waypoints, measurement.
inline constexpr std::size_t largest_table = 64U << 20;

/// The whole text of an ordinary file. Throws UserError when it cannot be read, is a folder, a pipe
/// or a device, or is too large.
/// @param what "case", for the message
/// @param most bytes
std::string read_text_file(const std::string& path, const std::string& what,
                           std::size_t most = largest_table);

/// The same of a file that is open already, from where it was read to. It was opened with
/// O_NONBLOCK, or else opening a pipe would have waited.
/// @param path for the message
std::string read_text_file(const FileDescriptor& file, const std::string& path,
                           const std::string& what, std::size_t most = largest_table);

} // namespace ionskin::base
