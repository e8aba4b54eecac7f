// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Equivalent shear strain of the paper, its equation (10); docs/model.md (9):
///   gamma = 2 sqrt(exy^2 + eyz^2 + exz^2)
/// from the off-diagonal tensor components of the small strain; never negative. It depends on the
/// choice of axes: a pure stretch at 45 degrees counts, the same stretch along an axis does not.
struct OffDiagonalShear {
  static constexpr const char* formula = "2 sqrt(exy^2 + eyz^2 + exz^2)";
  static constexpr std::array<bool, 6> reads{false, false, false, true, true, true};
  /// The measure of a strain [1].
  /// @param strain xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
