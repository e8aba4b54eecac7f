// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {

/// Removes blanks from both ends of a text.
/// @param blanks characters that count as blank
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

/// Splits a text at every separator and trims the parts. There is always one part more than there
/// are separators, so an empty text gives one empty part.
/// @param blanks characters that count as blank
std::vector<std::string> split(std::string_view text, char separator,
                               std::string_view blanks = " \t");

/// Makes a user's text safe to show in a message: on one line, with control characters and bytes
/// that are not UTF-8 escaped ("\\x1b"), and with the middle of a long text left out.
/// @param most length beyond which the text is shortened [bytes]
std::string shown(std::string_view text, std::size_t most = 120);

/// Makes a whole message, which may contain users' texts, safe to print: escapes as `shown` does,
/// but keeps line breaks and tabs, and limits the length and the number of lines.
std::string printable(std::string_view message);

/// Formats a text as one cell of a CSV file, with quotes if needed. A text that a spreadsheet would
/// take for a formula gets a leading apostrophe, so that it stays a text.
std::string csv_cell(std::string_view text);

/// True if the whole text is valid UTF-8.
bool is_utf8(std::string_view text);

} // namespace ionskin::base
