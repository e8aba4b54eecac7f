// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {

/// The text without the blanks at its ends.
std::string trimmed(std::string_view text, std::string_view blanks = " \t");

/// The parts before, between and after the separators, each trimmed; one even of an empty text.
std::vector<std::string> split(std::string_view text, char separator,
                               std::string_view blanks = " \t");

/// A user's text for a message: one line, control bytes and bytes that are not UTF-8 escaped
/// ("\\x1b"), the middle of a long one left out.
/// @param most bytes that are shown
std::string shown(std::string_view text, std::size_t most = 120);

/// A whole message that may hold users' texts: as `shown`, but lines and tabs stay, and both the
/// lines and their number are bounded.
std::string printable(std::string_view message);

/// One cell of a CSV file, quoted where it must be. A text that a spreadsheet would take for a
/// formula gets an apostrophe before it, which makes it a text there.
std::string csv_cell(std::string_view text);

/// True if all of the text is UTF-8.
bool is_utf8(std::string_view text);

} // namespace ionskin::base
