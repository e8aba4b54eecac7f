// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace ionskin::units {

/// True when udunits2 knows every name in the text. Aliases are those of `convert_unit`.
bool unit_is_known(const std::string& unit);

/// A value in a unit expressed in an SI unit of the same dimension, offsets included (20 degC is
/// 293.15 K); empty when the dimensions differ or a unit is unknown. The symbols M, mM, uM and nM
/// stand for mol/L and its parts, which udunits2 lacks. Safe to call from several threads (udunits2
/// itself is not).
std::optional<double> convert_unit(double value, const std::string& unit,
                                   const std::string& si_unit);

/// The unit written in base units, such as "m2.s-1"; empty when unknown.
std::string in_base_units(const std::string& unit);

} // namespace ionskin::units
