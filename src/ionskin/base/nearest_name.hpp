// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {

/// Edit distance of two names (optimal string alignment): smallest number of single-byte
/// insertions, deletions, replacements and swaps of neighbours that turn one into the other.
std::size_t edit_distance(std::string_view first, std::string_view second);

/// Finds the candidate closest to a misspelt name, to suggest it to the user. Empty when none is
/// close: one edit is allowed for every three characters of the name, and at least one.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

} // namespace ionskin::base
