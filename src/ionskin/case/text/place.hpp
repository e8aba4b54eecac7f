// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// A span of one line of a case file or of a `--set` argument, to point at in a message.
struct Place {
  std::string origin;     ///< file name, or "command line"
  std::size_t line = 0;   ///< from 1; 0 for a --set argument, which has no lines
  std::size_t column = 1; ///< from 1, in bytes
  std::size_t length = 1; ///< in bytes
  std::string line_text;  ///< of a long line what stands around the place
  std::size_t cut = 0;    ///< bytes of the line before `line_text`
};

/// A place and what is to be said about it.
struct Pointer {
  Place place;
  std::string note;
};

/// Several lines: origin, line number, the line itself and a caret under the place.
std::string excerpt(const Pointer& pointer);

/// The mistakes found in one case, each with its places and its remedy, so that a user sees all at
/// once.
class Problems {
public:
  /// Adds a mistake.
  /// @param message what is wrong, with the actual value
  /// @param pointers the offending places; two when two keys conflict; may be empty
  /// @param remedy what to do; may be empty when the message says it
  void add(const std::string& message, const std::vector<Pointer>& pointers,
           const std::string& remedy);

  bool empty() const { return texts_.empty(); }
  /// True if further problems are only counted: what costs work need not be made for them.
  bool full() const;
  /// Throws UserError with all problems when there are any.
  /// @param file the case, for the heading of several problems
  void throw_if_any(const std::string& file) const;

private:
  std::vector<std::string> texts_;
};

} // namespace ionskin
