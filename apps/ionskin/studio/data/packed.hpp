// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/json.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Packs a JSON heading and binary numbers into one message for the page: the length of the heading
/// [bytes] (32 bits, little endian), the heading, blanks up to a multiple of eight bytes, the
/// numbers in the byte order of this machine.
template <class Number>
std::string packed(const Json& heading, const std::vector<Number>& numbers) {
  std::string text = dump(heading);
  text.append((8 - (4 + text.size()) % 8) % 8, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string message(4 + text.size() + numbers.size() * sizeof(Number), '\0');
  std::memcpy(message.data(), &length, 4);
  std::memcpy(message.data() + 4, text.data(), text.size());
  std::memcpy(message.data() + 4 + text.size(), numbers.data(), numbers.size() * sizeof(Number));
  return message;
}

} // namespace ionskin::apps::studio
