// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/schema/schema.hpp"

#include <toml.hpp>

#include <string>
#include <variant>

namespace ionskin {

/// Result of `read_value` for a value that is refused.
struct BadValue {
  std::string message, remedy; ///< the mistake, and advice to the user
  /// The offending value, an entry of a list or the whole value; owned by the TOML tree.
  const toml::value* where = nullptr;
};

/// Reads one value and checks it against its row of the schema: type, dimension, range, choice.
/// @param key full name of the key, for messages
/// @return the value in SI units, or why it is refused
std::variant<Value, BadValue> read_value(const SchemaRow& row, const std::string& key,
                                         const toml::value& value);

/// Writes a value in SI units as text for people: "[0.003 m, 0.0015 m]".
std::string format_value(const SchemaRow& row, const Value& value);

} // namespace ionskin
