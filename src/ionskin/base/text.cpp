// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/text.hpp"

#include <algorithm>

namespace ionskin::base {

std::string trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::vector<std::string> split(std::string_view text, char separator, std::string_view blanks) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin), blanks));
    begin = end + 1;
  }
  return parts;
}

std::string foreign_separator(std::string_view header) {
  if (header.find(',') != std::string_view::npos) {
    return "";
  }
  if (header.find(';') != std::string_view::npos) {
    return "semicolons";
  }
  return header.find('\t') == std::string_view::npos ? "" : "tabs";
}

} // namespace ionskin::base
