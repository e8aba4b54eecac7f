// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Limits on the text of a case. They are far above what a case needs, and low enough that the
/// parser, which recurses into brackets and dotted keys, stays within its stack and within a
/// second.
namespace toml_limits {
inline constexpr std::size_t bytes = 1U << 20; ///< length of the whole text [bytes]
inline constexpr std::size_t values = 50'000;  ///< number of = signs and commas outside quotes
inline constexpr std::size_t depth = 16;       ///< nested brackets, or dotted parts of a key
inline constexpr std::size_t name_bytes = 256; ///< length of the name of a key or section [bytes]
inline constexpr std::size_t text_bytes = 1U << 15; ///< length of a string in quotes [bytes]
inline constexpr std::size_t braced = 500;          ///< number of values in braces in one line
} // namespace toml_limits

/// Checks the text of a case against `toml_limits` before it is parsed: its size, its depth, its
/// bytes (UTF-8 without control characters), and its numbers, which the parser would clamp to the
/// range of a machine number.
/// @param file name of the case, for messages
/// @return ascending offsets [bytes] behind commas of lists, at which long lines may be broken
/// Throws UserError that points at the offending position.
std::vector<std::size_t> check_toml_limits(const std::string& text, const std::string& file);

} // namespace ionskin
