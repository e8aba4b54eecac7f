// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <toml.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

/// First byte and length of what defines a value: the value itself, or the header of its table.
struct TextSpan {
  std::size_t begin = 0, length = 0;
};

/// The values of a TOML text and where they stand in it. Takes time in proportion to the text, also
/// where a long list stands in one line.
class TomlText {
public:
  /// Parses a whole case.
  /// @param file name shown in messages
  /// Throws UserError with an excerpt when the text is not TOML or beyond its limits.
  TomlText(std::string text, const std::string& file);

  const std::string& text() const { return text_; }
  const toml::value& root() const { return root_; }
  /// This text with another tree of its values, which still stand where they stood.
  TomlText with_root(toml::value root) const;

  /// Span of a value of this text.
  TextSpan span(const toml::value& value) const;
  /// The key that stands before a value ("length" of `length = "15 mm"`), or the value's own span
  /// for table headers and array elements.
  TextSpan key_span(const toml::value& value) const;
  /// Children of a table in the order of the text.
  std::vector<std::pair<std::string, const toml::value*>>
  children_in_order(const toml::value& table) const;

private:
  std::size_t in_text(std::size_t parsed) const;
  [[noreturn]] void refuse(const std::string& message, const toml::source_location* where,
                           const std::string& parsed) const;

  std::string text_, file_;
  std::vector<std::size_t>
      breaks_; ///< places where the text that is parsed has newlines of its own
  toml::value root_;
};

} // namespace ionskin
