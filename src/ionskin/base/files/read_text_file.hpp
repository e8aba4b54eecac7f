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

/// Text of an ordinary file that is open already, from its current position to its end; errors as
/// above. The caller opened it with O_NONBLOCK: opening a pipe would wait otherwise.
/// @param path for the message
std::string read_text_file(const FileDescriptor& file, const std::string& path,
                           const std::string& what, std::size_t most = largest_table);

} // namespace ionskin::base
