// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Bounds of a case's text. Far above what a case needs, and low enough that the reader, which
/// descends into brackets and dotted keys, stays within its stack and within a second.
namespace toml_limits {
inline constexpr std::size_t bytes = 1U << 20;      ///< of the whole text
inline constexpr std::size_t values = 50'000;       ///< signs = and entries of lists
inline constexpr std::size_t depth = 16;            ///< of nested brackets, of parts of a key
inline constexpr std::size_t name_bytes = 256;      ///< of a key or a section's name
inline constexpr std::size_t text_bytes = 1U << 15; ///< of a text in quotes
inline constexpr std::size_t braced = 500;          ///< values in braces in one line
} // namespace toml_limits

/// Judges a text before it is parsed: its size, its depth, its bytes (UTF-8 without control
/// characters), and its numbers, which the parser would clamp to what a machine can hold.
/// @param file name shown in the message
/// @return positions behind commas of lists at which long lines may be broken, ascending
/// Throws UserError pointing at the place.
std::vector<std::size_t> check_toml_limits(const std::string& text, const std::string& file);

} // namespace ionskin
