// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace ionskin::laws {

/// One row of the table of shear measures: the scalar gamma made of a small strain. Every measure
/// is even under a reflection in y, on which the half model relies.
struct ShearMeasure {
  std::string_view name;     ///< value of `coupling.measure`
  std::string_view formula;  ///< in words and components of the strain e
  std::array<bool, 6> reads; ///< components that it depends on: others are not computed for it
  /// The measure of a strain [1].
  /// @param strain xx, yy, zz, yz, xz, xy [1]
  double (*at)(const std::array<double, 6>& strain);
};

/// All measures; the first is the default of a case.
std::span<const ShearMeasure> shear_measures();

/// The measure of a name that the schema has checked.
const ShearMeasure& shear_measure(std::string_view name);

/// The measure at each point of a strain field.
/// @param component six components, each [points], empty of those that the measure does not read
/// [1]
std::vector<double> evaluate_shear(const ShearMeasure& measure,
                                   const std::array<std::vector<double>, 6>& component);

} // namespace ionskin::laws
