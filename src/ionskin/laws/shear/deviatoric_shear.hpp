// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Equivalent shear strain of the deviator e' = e - tr(e)/3 I, docs/model.md (10):
///   gamma = sqrt(2 e':e'),
/// twice the root of the second invariant of e' (J2 theory, von Mises 1913). It does not depend on
/// the choice of axes, counts every change of shape and no change of volume, is never negative, and
/// equals the engineering shear in simple shear.
struct DeviatoricShear {
  static constexpr const char* formula = "sqrt(2 e':e') of the deviator e' (whatever the axes)";
  static constexpr std::array<bool, 6> reads{true, true, true, true, true, true};
  /// The measure of a strain [1].
  /// @param strain xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
