// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/units/dimension.hpp"

#include <string>
#include <string_view>

namespace ionskin::units {

/// Parses a number with a unit, such as "15 mm", "7e-11 m2/s" or "20 degC" (absolute: 293.15 K),
/// and returns its value in SI units.
/// @param text number and unit; the unit may be missing only if `expected` is `number`
/// @param expected the dimension that the text must have
/// Throws UserError when the text is not a finite number, or its unit is missing, unknown (the
/// message names the nearest known one) or of another dimension. The message does not say where the
/// text stands: the caller adds that.
double parse_quantity(std::string_view text, Dimension expected);

/// Writes a value in SI units with its unit, for messages: "0.015 m". A pure number has no unit.
std::string format_si(double value, Dimension dimension);

} // namespace ionskin::units
