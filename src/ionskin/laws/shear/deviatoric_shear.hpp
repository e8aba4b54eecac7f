// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Shear measure `deviatoric`, the equivalent shear strain of the strain deviator
/// e' = e - tr(e)/3 I, docs/model.md (10):
///   gamma = sqrt(2 e':e'),
/// twice the square root of the second invariant of e' (J2 theory, von Mises 1913). It does not
/// depend on the choice of axes, is never negative, responds to changes of shape but not of volume,
/// and equals the engineering shear strain in simple shear.
struct DeviatoricShear {
  static constexpr const char* formula = "sqrt(2 e':e') of the deviator e' (whatever the axes)";
  static constexpr std::array<bool, 6> reads{true, true, true, true, true, true};
  /// Computes gamma [1] from a strain.
  /// @param strain tensor components xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
