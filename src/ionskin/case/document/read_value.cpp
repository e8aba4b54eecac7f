// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/read_value.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/units/quantity.hpp"
#include "ionskin/units/unit_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

namespace ionskin {

namespace {

// Reads one value by its row. Throws BadValue when the value is refused.
class ValueReader {
public:
  ValueReader(const SchemaRow& row, const std::string& key) : row_(row), key_(key) {}

  Value read(const toml::value& value) const {
    if (row_.over_humidity && value.is_array())
      return over_humidity(value);
    switch (row_.type) {
    case ValueType::text:
      return {text(value), {}};
    case ValueType::choice:
      return {choice(value), {}};
    case ValueType::integer:
      return {{}, {integer(value)}};
    case ValueType::number:
      return {{}, {number(value)}};
    case ValueType::quantity:
      return scalar_quantity(value);
    case ValueType::number_pair:
      return {{}, pair(value, &ValueReader::number)};
    case ValueType::quantity_pair:
      return {{}, pair(value, &ValueReader::quantity), row_.dimension};
    case ValueType::number_list:
      return {{}, list(value, &ValueReader::number)};
    case ValueType::quantity_list:
      return {{}, list(value, &ValueReader::quantity), row_.dimension};
    }
    throw InternalError("a value type without a reader");
  }

private:
  using Read = double (ValueReader::*)(const toml::value&) const;

  [[noreturn]] static void refuse(const toml::value& where, const std::string& message,
                                  const std::string& remedy) {
    throw BadValue{message, remedy, &where};
  }

  static std::string written(const toml::value& value) {
    if (!value.is_floating())
      return base::shown(toml::format(value, 10000));
    // toml11 would write 1e-6 as 9.9999999999999995e-07.
    const std::string shortest = fmt::format("{}", value.as_floating());
    const bool whole = shortest.find_first_not_of("-0123456789") == std::string::npos;
    return whole ? shortest + ".0" : shortest;
  }

  std::string example() const { return units::dimension_info(row_.dimension).examples.front(); }

  std::string text(const toml::value& value) const {
    if (!value.is_string())
      refuse(value, fmt::format("{} = {} is not a text", key_, written(value)), "put it in quotes");
    const std::string& text = value.as_string().str;
    const auto is_control = [](unsigned char letter) { return letter < 0x20 || letter == 0x7F; };
    if (std::ranges::any_of(text, is_control))
      refuse(value, fmt::format("{} = {} holds control characters", key_, written(value)),
             "write a text of one line without \\u00.. escapes");
    return text;
  }

  std::string choice(const toml::value& value) const {
    const std::string name = text(value);
    std::vector<std::string> names;
    std::string list;
    for (const Choice& allowed : row_.choices) {
      if (allowed.name == name && allowed.in_this_version)
        return name;
      if (!allowed.in_this_version)
        continue;
      names.push_back(allowed.name);
      list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", allowed.name);
    }
    for (const Choice& later : row_.choices)
      if (later.name == name)
        refuse(value, fmt::format("{} = \"{}\" is not in this version", key_, base::shown(name)),
               "choose " + list);
    const std::string nearest = base::nearest_name(name, names);
    refuse(value, fmt::format("{} = \"{}\" is unknown", key_, base::shown(name)),
           (nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest)) +
               "known: " + list);
  }

  double integer(const toml::value& value) const {
    if (!value.is_integer())
      refuse(value, fmt::format("{} = {} is not an integer", key_, written(value)),
             "write a whole number without quotes");
    return in_range(value, static_cast<double>(value.as_integer()));
  }

  double number(const toml::value& value) const {
    if (value.is_integer())
      return in_range(value, static_cast<double>(value.as_integer()));
    if (!value.is_floating())
      refuse(value, fmt::format("{} = {} is not a number", key_, written(value)),
             "write a plain number without quotes and without a unit");
    return in_range(value, value.as_floating());
  }

  /// Reads a quantity in the row's dimension, or in its alternative dimension if the text has that
  /// one.
  Value scalar_quantity(const toml::value& value) const {
    if (row_.other_dimension && value.is_string()) {
      std::optional<double> number;
      try {
        number = units::parse_quantity(value.as_string().str, *row_.other_dimension);
      } catch (const UserError&) { // read below in the row's own dimension
      }
      if (number)
        return {{}, {in_range(value, *number, *row_.other_dimension)}, *row_.other_dimension};
    }
    return {{}, {quantity(value)}, row_.dimension};
  }

  double quantity(const toml::value& value) const {
    if (value.is_integer() || value.is_floating())
      refuse(value,
             fmt::format("{} has no unit: {} is a bare number, expected {}", key_, written(value),
                         in_each_dimension(" or ",
                                           [](units::Dimension dimension) {
                                             return units::dimension_info(dimension).name;
                                           })),
             fmt::format("write it as a text with its unit, such as {}; {}",
                         in_each_dimension(" or ",
                                           [&](units::Dimension dimension) {
                                             return '"' + with_unit(value, dimension) + '"';
                                           }),
                         in_each_dimension("; ", usual_units)));
    if (!value.is_string())
      refuse(value, fmt::format("{} = {} is not a quantity", key_, written(value)),
             fmt::format("write a text with a number and a unit, such as \"1.5 {}\"", example()));
    double result = 0;
    try {
      result = units::parse_quantity(value.as_string().str, row_.dimension);
    } catch (const UserError& error) {
      refuse(value, fmt::format("{}: {}", key_, error.what()),
             in_each_dimension("; ", usual_units));
    }
    return in_range(value, result, row_.dimension);
  }

  /// Suggests a unit for a bare number: the SI unit if the number is then in range, else the first
  /// usual unit with which it is.
  std::string with_unit(const toml::value& value, units::Dimension dimension) const {
    const units::DimensionInfo& info = units::dimension_info(dimension);
    std::vector<std::string> candidates{info.si_unit};
    candidates.insert(candidates.end(), info.examples.begin(), info.examples.end());
    const double number =
        value.is_integer() ? static_cast<double>(value.as_integer()) : value.as_floating();
    for (const std::string& unit : candidates) {
      const auto si = units::convert_unit(number, unit, info.si_unit);
      if (si && row_.range.contains(*si))
        return written(value) + " " + unit;
    }
    return "1.5 " + info.si_unit;
  }

  /// Joins a text for the row's dimension and, if it has one, for its alternative dimension.
  std::string in_each_dimension(std::string_view between,
                                const std::function<std::string(units::Dimension)>& text) const {
    std::string all = text(row_.dimension);
    if (row_.other_dimension)
      all += fmt::format("{}{}", between, text(*row_.other_dimension));
    return all;
  }

  static std::string usual_units(units::Dimension dimension) {
    std::string list;
    for (const std::string& unit : units::dimension_info(dimension).examples)
      list += (list.empty() ? "" : ", ") + unit;
    return fmt::format("units of {}: {}", units::dimension_info(dimension).name, list);
  }

  double in_range(const toml::value& value, double number) const {
    return in_range(value, number, row_.dimension);
  }

  double in_range(const toml::value& value, double number, units::Dimension dimension) const {
    if (std::isfinite(number) && row_.range.contains(number))
      return number;
    const std::string in_si = units::format_si(number, dimension);
    const std::string as_written = written(value);
    const bool same = as_written == in_si || as_written == "\"" + in_si + "\"";
    const std::string si = same ? "" : fmt::format(" ({})", in_si);
    refuse(value, fmt::format("{} = {}{} is out of range", key_, as_written, si),
           fmt::format("it must be {}{}{}", describe(row_.range, dimension),
                       row_.range_reason.empty() ? "" : ": ", row_.range_reason));
  }

  std::vector<double> list(const toml::value& value, Read read_entry) const {
    if (!value.is_array())
      refuse(value, fmt::format("{} = {} is not a list", key_, written(value)),
             row_.type == ValueType::number_list
                 ? "write a list in brackets, such as [0.5, 1]"
                 : fmt::format("write a list in brackets, such as [\"1 {}\"]", example()));
    std::vector<double> numbers;
    for (const toml::value& entry : value.as_array())
      numbers.push_back((this->*read_entry)(entry));
    return numbers;
  }

  Value over_humidity(const toml::value& value) const {
    if (value.as_array().size() < 2)
      refuse(value,
             fmt::format("{} = {} is a list of fewer than two entries", key_, written(value)),
             "write one value, or one for each humidity of the material");
    const Read entry =
        row_.type == ValueType::number ? &ValueReader::number : &ValueReader::quantity;
    return {{}, list(value, entry), row_.dimension};
  }

  std::vector<double> pair(const toml::value& value, Read read_entry) const {
    const bool quantity = row_.type == ValueType::quantity_pair;
    const std::string form =
        quantity ? fmt::format("[\"3 {0}\", \"1.5 {0}\"]", example()) : "[1, 0]";
    if (!value.is_array() || value.as_array().size() != 2)
      refuse(value, fmt::format("{} = {} is not a pair", key_, written(value)),
             fmt::format("write two values, along x and along y, such as {}", form));
    return list(value, read_entry);
  }

  const SchemaRow& row_;
  const std::string& key_;
};

} // namespace

std::variant<Value, BadValue> read_value(const SchemaRow& row, const std::string& key,
                                         const toml::value& value) {
  try {
    return ValueReader(row, key).read(value);
  } catch (const BadValue& bad) {
    return bad;
  }
}

std::string format_value(const SchemaRow& row, const Value& value) {
  if (row.type == ValueType::text || row.type == ValueType::choice)
    return value.text;
  std::string list;
  for (const double number : value.numbers)
    list += (list.empty() ? "" : ", ") + units::format_si(number, value.dimension);
  const bool scalar = row.type == ValueType::integer || row.type == ValueType::number ||
                      row.type == ValueType::quantity;
  return scalar && value.numbers.size() == 1 ? list : "[" + list + "]";
}

} // namespace ionskin
