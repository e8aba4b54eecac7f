// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace ionskin::laws {

/// One row of the table of shear measures. A shear measure computes from the small strain tensor
/// the scalar gamma that drives the coupling laws. Every measure is even under a reflection in y,
/// so that cases symmetric in y can be solved on half of the skin.
struct ShearMeasure {
  std::string_view name;    ///< value of the key `coupling.measure`
  std::string_view formula; ///< formula in the components of the strain e, for the user
  /// True for each component (xx, yy, zz, yz, xz, xy) that the measure depends on; no others are
  /// computed for it.
  std::array<bool, 6> reads;
  /// Computes gamma [1] from a strain.
  /// @param strain tensor components xx, yy, zz, yz, xz, xy [1]
  double (*at)(const std::array<double, 6>& strain);
};

/// Table of all shear measures; the first is the default of a case.
std::span<const ShearMeasure> shear_measures();

/// Finds a shear measure by its name. Throws InternalError for an unknown name, which the schema
/// has excluded.
const ShearMeasure& shear_measure(std::string_view name);

/// Computes gamma [1] at each point of a strain field.
/// @param component tensor components xx, yy, zz, yz, xz, xy, each [points] [1]; components that
/// the
///   measure does not read may be empty
std::vector<double> evaluate_shear(const ShearMeasure& measure,
                                   const std::array<std::vector<double>, 6>& component);

} // namespace ionskin::laws
