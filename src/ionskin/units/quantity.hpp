// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/units/dimension.hpp"

#include <string>
#include <string_view>

namespace ionskin::units {

/// SI value of a text such as "15 mm", "7e-11 m2/s" or "20 degC" (absolute: 293.15 K).
/// @param expected the dimension that the text must have
/// Throws UserError: not a number, not finite, missing unit, unknown unit (with the nearest known
/// one), or wrong dimension. The message has no place; the caller knows it.
double parse_quantity(std::string_view text, Dimension expected);

/// A value with its SI unit for messages: "0.015 m"; no unit for a pure number.
std::string format_si(double value, Dimension dimension);

} // namespace ionskin::units
