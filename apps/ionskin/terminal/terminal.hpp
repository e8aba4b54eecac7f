// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::apps {

/// Columns of the terminal behind a file descriptor, asked anew at every call since windows change:
/// what the terminal says, else COLUMNS, else 80. At least 20.
std::size_t terminal_width(int descriptor);

/// Text broken at blanks into lines of at most `width` columns, the second and later ones behind
/// `indent` blanks; a longer word stands on a line of its own. Without a newline at its end.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// A paragraph for stdout, or for another file descriptor, with a newline: wrapped on a terminal,
/// one line in a file.
std::string paragraph(std::string_view text, std::size_t indent, int descriptor = 1);

/// Words as one would type them in a shell.
std::string shell_text(const std::vector<std::string>& words);

/// The whole command line of `ionskin`, whichever part of it this program is.
std::string command_as_typed(int argc, char** argv);

/// "12 s", "3 min 20 s", "1 h 05 min".
std::string duration_text(double seconds);

} // namespace ionskin::apps
