// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace ionskin::results {

/// The bytes of a file with the damage that a seed draws: flipped or replaced bytes, a range of
/// zeros or of noise, or a lost end.
inline std::string corrupted(std::string bytes, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&random](std::size_t bound) {
    return random() % std::max<std::size_t>(bound, 1);
  };
  const auto range = [&](const auto& byte) {
    const std::size_t begin = below(bytes.size()), end = begin + 1 + below(64);
    std::generate(bytes.begin() + static_cast<long>(begin),
                  bytes.begin() + static_cast<long>(std::min(end, bytes.size())), byte);
  };
  switch (below(5)) {
  case 0: // one bit
    bytes[below(bytes.size())] ^= static_cast<char>(1u << below(8));
    break;
  case 1: // some bytes
    for (std::size_t left = 1 + below(8); left > 0; --left) {
      bytes[below(bytes.size())] = static_cast<char>(below(256));
    }
    break;
  case 2:
    range([] { return '\0'; });
    break;
  case 3:
    range([&] { return static_cast<char>(below(256)); });
    break;
  default:
    bytes.resize(below(bytes.size()));
  }
  return bytes;
}

/// Number of damaged files that a test tries; more by hand, through the environment.
inline std::uint32_t corruptions(std::uint32_t usually) {
  const char* wanted = std::getenv("IONSKIN_CORRUPTIONS");
  return wanted == nullptr ? usually : static_cast<std::uint32_t>(std::stoul(wanted));
}

} // namespace ionskin::results
