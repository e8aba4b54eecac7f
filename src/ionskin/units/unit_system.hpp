// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ionskin::units {

/// True if a text such as "mm2/s" is a unit: udunits2 or the aliases of `convert_unit` know every
/// name in it, and its only numbers are exponents, or the 1 of "1/s". Throws UserError when the
/// database of udunits2 cannot be read.
bool unit_is_known(const std::string& unit);

/// Converts a value from a unit to an SI unit, offsets included (20 degC is 293.15 K). Returns
/// empty when the dimensions differ or a unit is unknown. The symbols M, mM, uM, nM and pM stand
/// for mol/L and its parts, which udunits2 lacks, deg for degrees of arc, and sqrt(Hz) for the root
/// of hertz. Safe to call from several threads (udunits2 itself is not).
/// @param value in `unit`
/// @param si_unit unit of the result, in the spelling of udunits2
/// Throws UserError when the database of udunits2 cannot be read.
std::optional<double> convert_unit(double value, const std::string& unit,
                                   const std::string& si_unit);

/// Writes a unit in SI base units, such as "m2.s-1"; empty when the unit is unknown.
std::string in_base_units(const std::string& unit);

} // namespace ionskin::units
