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

/// What separates the columns of a header where it is no comma: "semicolons", "tabs", or empty.
std::string foreign_separator(std::string_view header);
inline constexpr const char* foreign_separator_remedy =
    "separate columns by commas and write decimal points: sed 's/,/./g; s/[;\\t]/,/g' FILE";

} // namespace ionskin::base
