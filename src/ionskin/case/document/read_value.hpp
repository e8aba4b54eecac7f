// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/schema/schema.hpp"

#include <toml.hpp>

#include <string>
#include <variant>

namespace ionskin {

/// Reason for which a value was refused.
struct BadValue {
  std::string message, remedy;
  const toml::value* where =
      nullptr; ///< the offending value: an entry of a list, or the whole value
};

/// Reads one value as its row demands: type, dimension, range, choice.
/// @param key the concrete key, for messages
std::variant<Value, BadValue> read_value(const SchemaRow& row, const std::string& key,
                                         const toml::value& value);

/// The value in SI units, for people: "[0.003 m, 0.0015 m]".
std::string format_value(const SchemaRow& row, const Value& value);

} // namespace ionskin
