// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Position in a user's text, as an error message shows it: a span of one line of a file or of a
/// `--set` argument.
struct Place {
  std::string origin;     ///< file name, or "command line"
  std::size_t line = 0;   ///< from 1; 0 for a --set argument, which has no lines
  std::size_t column = 1; ///< from 1, in bytes
  std::size_t length = 1; ///< in bytes
  std::string line_text;  ///< text of the line; of a long line the part around the span
  std::size_t cut = 0;    ///< bytes of the line that were cut before `line_text`
};

/// A position to point at in an error message, with an optional note on it.
struct Pointer {
  Place place;
  std::string note; ///< printed behind the caret; may be empty
};

/// Formats a position as several lines of a message: origin and line number, the line itself, and
/// carets under the span.
std::string excerpt(const Pointer& pointer);

/// Collects the mistakes found in one case, each with its positions and its remedy, so that the
/// user sees all of them at once.
class Problems {
public:
  /// Adds a mistake. If `full()`, it is only counted.
  /// @param message the mistake, with the actual value
  /// @param pointers its positions; two when two keys conflict; may be empty
  /// @param remedy advice to the user; may be empty when the message says it
  void add(const std::string& message, const std::vector<Pointer>& pointers,
           const std::string& remedy);

  bool empty() const { return texts_.empty(); }
  /// True if further mistakes are only counted and not shown, so that callers can skip costly
  /// messages.
  bool full() const;
  /// Throws UserError with all mistakes if there are any; else does nothing.
  /// @param file name of the case, for the heading above several mistakes
  void throw_if_any(const std::string& file) const;

private:
  std::vector<std::string> texts_;
};

} // namespace ionskin
