// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::apps {

/// Width of the terminal behind a file descriptor [columns]: that which the terminal reports, else
/// the environment's COLUMNS, else 80; at least 20. Every call asks the terminal again, since its
/// window may change.
std::size_t terminal_width(int descriptor);

/// Wraps a text at blanks into lines of at most `width` columns. Lines after the first begin with
/// `indent` blanks. A word longer than a line stands on a line of its own. The text has no newline
/// at its end.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// Text of a paragraph with a newline at its end, for output to a file descriptor (1: stdout):
/// wrapped to the width of a terminal, as `wrapped` does; one line where the output is not a
/// terminal.
std::string paragraph(std::string_view text, std::size_t indent, int descriptor = 1);

/// Quotes the words of a command where a shell needs it, and joins them with blanks.
std::string shell_text(const std::vector<std::string>& words);

/// Command line of this process as the user typed it, quoted for a shell, with `ionskin` as the
/// program even where one of its parts, such as ionskin-solver, is running.
std::string command_as_typed(int argc, char** argv);

/// Text of a duration [s], rounded to seconds: "12 s", "3 min 20 s"; from an hour on to minutes: "1
/// h 05 min".
std::string duration_text(double seconds);

} // namespace ionskin::apps
