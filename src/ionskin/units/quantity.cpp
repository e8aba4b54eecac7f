// SPDX-License-Identifier: Apache-2.0
#include "ionskin/units/quantity.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/units/unit_system.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace ionskin::units {

namespace {

std::string expectation(Dimension expected) {
  const DimensionInfo& info = dimension_info(expected);
  if (expected == Dimension::number)
    return "expected a pure number";
  return fmt::format("expected {} such as \"{}\"", info.name, info.examples.front());
}

struct NumberAndUnit {
  double number = 0;
  std::string unit;
};

// Limit on the length of a quantity [bytes], more than any number with its unit needs.
constexpr std::size_t longest_quantity = 128;

NumberAndUnit split(std::string_view text, Dimension expected) {
  const std::string clean = base::trimmed(text);
  if (clean.size() > longest_quantity)
    throw UserError(
        fmt::format("\"{}\" is too long for a number with its unit", base::shown(text)));
  const char* begin = clean.data() + (clean.starts_with('+') ? 1 : 0);
  const char* const end = clean.data() + clean.size();
  NumberAndUnit result;
  const auto [rest, status] = std::from_chars(begin, end, result.number);
  if (status == std::errc::result_out_of_range)
    throw UserError(fmt::format(
        "the number in \"{}\" is too large or too small: numbers reach from 1e-307 to 1e308",
        base::shown(text)));
  if (status != std::errc() || !std::isfinite(result.number))
    throw UserError(fmt::format("\"{}\" does not begin with a number; {}, written \"1.5 {}\"",
                                base::shown(text), expectation(expected),
                                dimension_info(expected).examples.front()));
  result.unit = base::trimmed(std::string_view(rest, static_cast<std::size_t>(end - rest)));
  if (result.unit.size() > 1 && result.unit[0] == ',' && result.unit[1] >= '0' &&
      result.unit[1] <= '9')
    throw UserError(fmt::format("\"{}\" has a comma in its number: write a decimal point, and "
                                "thousands without marks between them",
                                base::shown(text)));
  return result;
}

/// True if a unit is probably one of angles, which udunits2 does not distinguish from pure numbers.
bool is_angle(const std::string& unit) {
  for (const char* part : {"rad", "deg", "arc", "°"})
    if (unit.find(part) != std::string::npos)
      return true;
  return false;
}

std::string name_of_dimension(const std::string& unit) {
  if (is_angle(unit) && convert_unit(1.0, unit, dimension_info(Dimension::angle).si_unit))
    return dimension_info(Dimension::angle).name;
  for (const Dimension dimension : all_dimensions())
    if (convert_unit(1.0, unit, dimension_info(dimension).si_unit))
      return dimension_info(dimension).name;
  for (const DimensionInfo& other : other_dimensions())
    if (convert_unit(1.0, unit, other.si_unit))
      return other.name;
  return "a quantity in " + in_base_units(unit);
}

[[noreturn]] void throw_unknown_unit(const std::string& unit, std::string_view text,
                                     Dimension expected) {
  const DimensionInfo& info = dimension_info(expected);
  std::string nearest = base::nearest_name(unit, info.examples);
  if (nearest.empty())
    nearest = base::nearest_name(unit, usual_units());
  const std::string hint =
      nearest.empty() ? std::string() : fmt::format("; did you mean \"{}\"?", nearest);
  throw UserError(fmt::format("unknown unit \"{}\" in \"{}\"{}{}", base::shown(unit),
                              base::shown(text), hint,
                              nearest.empty() ? "; " + expectation(expected) : ""));
}

[[noreturn]] void throw_wrong_dimension(const std::string& unit, std::string_view text,
                                        Dimension expected) {
  const bool celsius = expected == Dimension::temperature && (unit == "C" || unit == "F");
  throw UserError(fmt::format("\"{}\" has the wrong dimension: {}, got {}{}", base::shown(text),
                              expectation(expected), name_of_dimension(unit),
                              celsius ? fmt::format("; did you mean \"deg{}\"?", unit) : ""));
}

} // namespace

double parse_quantity(std::string_view text, Dimension expected) {
  const auto [number, unit] = split(text, expected);
  const DimensionInfo& info = dimension_info(expected);
  if (unit.empty()) {
    if (expected == Dimension::number)
      return number;
    throw UserError(
        fmt::format("missing unit in \"{}\": {}", base::shown(text), expectation(expected)));
  }
  const auto value = convert_unit(number, unit, info.si_unit);
  if (!value && !unit_is_known(unit))
    throw_unknown_unit(unit, text, expected);
  if (!value || (expected == Dimension::angle && !is_angle(unit)))
    throw_wrong_dimension(unit, text, expected);
  if (!std::isfinite(*value))
    throw UserError(fmt::format("\"{}\" is too large to be represented in {}", base::shown(text),
                                info.si_unit));
  return *value;
}

std::string format_si(double value, Dimension dimension) {
  if (dimension == Dimension::number)
    return fmt::format("{:.10g}", value);
  return fmt::format("{:.10g} {}", value, dimension_info(dimension).si_unit);
}

} // namespace ionskin::units
