// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace ionskin::base {

/// Parses a size such as "500 MB" or "8 GB" into bytes; units are kB, MB, GB and TB, powers of
/// 1000. Throws UserError when the text is no such size.
/// @param name option or variable that the text is the value of, for the message:
///   "IONSKIN_MEMORY_LIMIT"
std::uintmax_t byte_count(const std::string& name, const std::string& text);

/// Formats a number of bytes for a reader: "5.8 MB", "1.2 GB".
std::string byte_text(double bytes);

} // namespace ionskin::base
