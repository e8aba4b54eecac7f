// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {

/// Smallest number of single-character insertions, deletions, replacements and swaps of neighbours
/// that turn one name into the other (optimal string alignment distance).
std::size_t edit_distance(std::string_view first, std::string_view second);

/// The candidate closest to a misspelt name, or an empty string when none is close: at most one
/// edit for every three characters, and at least one.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

} // namespace ionskin::base
