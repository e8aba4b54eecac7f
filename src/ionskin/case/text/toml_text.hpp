// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <toml.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

// What toml11 knows about positions, as offsets into the text.

/// The values of a text, or nothing when it is no TOML.
std::optional<toml::value> try_parse_toml(const std::string& text);

/// Parses a whole case; throws UserError with toml11's own excerpt when the text is no TOML.
/// @param file name shown in the message
toml::value parse_toml(const std::string& text, const std::string& file);

/// First byte and length of what defines a value: the value itself, or the header of its table.
struct TextSpan {
  std::size_t begin = 0, length = 0;
};
TextSpan value_span(const std::string& text, const toml::value& value);

/// The key that stands before a value ("length" of `length = "15 mm"`), or the value's own span for
/// table headers and array elements.
TextSpan key_span(const std::string& text, const toml::value& value);

/// Children of a table in the order of the text.
std::vector<std::pair<std::string, const toml::value*>> children_in_order(const std::string& text,
                                                                          const toml::value& table);

/// True for tables that stand under a [header], a [[header]] or are made by one.
bool has_header(const std::string& text, const toml::value& table);

} // namespace ionskin
