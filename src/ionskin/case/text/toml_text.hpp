// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <toml.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

/// Span of a text that defines a value: the value itself, or the header of a table. Offset and
/// length in bytes.
struct TextSpan {
  std::size_t begin = 0, length = 0;
};

/// A parsed TOML text: its tree of values, and the span of each value in the text. Parsing takes
/// time in proportion to the length of the text, even if a long list is written on one line.
class TomlText {
public:
  /// Parses a whole text.
  /// @param file name of the case, for messages
  /// Throws UserError with an excerpt when the text is not TOML or exceeds `toml_limits`.
  TomlText(std::string text, const std::string& file);

  const std::string& text() const { return text_; }
  const toml::value& root() const { return root_; }
  /// Copies this text with another tree.
  /// @param root rearrangement of values of this text, so that their spans stay valid
  TomlText with_root(toml::value root) const;

  /// Finds the span of a value of this text; {0, 0} if its origin is unknown.
  TextSpan span(const toml::value& value) const;
  /// Finds the span of the key before a value ("length" of `length = "15 mm"`), or the span of the
  /// value itself for headers of tables and entries of lists.
  TextSpan key_span(const toml::value& value) const;
  /// Lists name and value of the entries of a table in the order of the text. The pointers refer to
  /// `table`.
  std::vector<std::pair<std::string, const toml::value*>>
  children_in_order(const toml::value& table) const;

private:
  /// Converts an offset of the parsed text to one of the original text.
  std::size_t in_text(std::size_t parsed) const;
  [[noreturn]] void refuse(const std::string& message, const toml::source_location* where,
                           const std::string& parsed) const;

  std::string text_, file_;
  /// Offsets at which newlines were inserted into the text for the parser.
  std::vector<std::size_t> breaks_;
  toml::value root_;
};

} // namespace ionskin
