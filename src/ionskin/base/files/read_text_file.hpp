// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <cstddef>
#include <string>

namespace ionskin::base {

/// Largest size of a file with a table of numbers [bytes]: height map, waypoints or measurement.
inline constexpr std::size_t largest_table = 64U << 20;

/// Reads the whole text of a regular file.
/// @param what kind of file, for the message: "case"
/// @param most largest allowed size [bytes]
/// Throws UserError when the file cannot be read, is a folder, a pipe or a device, or is too large.
std::string read_text_file(const std::string& path, const std::string& what,
                           std::size_t most = largest_table);

/// Reads the text of a regular file that is already open, from its current position to its end,
/// with the errors of the overload for a path.
/// @param file opened for reading with O_NONBLOCK, without which opening a pipe would wait
/// @param path of the file, for the message
std::string read_text_file(const FileDescriptor& file, const std::string& path,
                           const std::string& what, std::size_t most = largest_table);

} // namespace ionskin::base
