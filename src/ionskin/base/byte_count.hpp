// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace ionskin::base {

/// Bytes of a text such as "500 MB" or "8 GB". Throws UserError otherwise.
/// @param name what the text was given for: "IONSKIN_MEMORY_LIMIT"
std::uintmax_t byte_count(const std::string& name, const std::string& text);

/// A number of bytes as a text: "5.8 MB", "1.2 GB".
std::string byte_text(double bytes);

} // namespace ionskin::base
