// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/read_text_file.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ionskin {

std::string read_text_file(const std::string& path, const std::string& what) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw UserError(fmt::format("the {} file {} is a folder\n  = name a file", what, path));
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw UserError(
        fmt::format("the {} file {} cannot be read: {}\n  = check its name and its permissions",
                    what, path, std::strerror(errno)));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

} // namespace ionskin
