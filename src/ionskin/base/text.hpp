// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {

/// What may stand around an entry of a CSV file; with the end of a Windows line.
inline constexpr std::string_view csv_blanks = " \t\r\"";

/// The text without the blanks at its ends.
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

/// The parts before, between and after the separators, each trimmed; one even of an empty text.
std::vector<std::string> split(std::string_view text, char separator,
                               std::string_view blanks = " \t");

} // namespace ionskin::base
