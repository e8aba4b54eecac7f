// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// The whole text of a file. Throws UserError when it cannot be read.
/// @param what "case", for the message
std::string read_text_file(const std::string& path, const std::string& what);

} // namespace ionskin
