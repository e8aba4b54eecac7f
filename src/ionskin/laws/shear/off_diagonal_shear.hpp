// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Shear measure `off-diagonal`, the equivalent shear strain of the paper that ionskin reproduces
/// (its equation (10)), docs/model.md (9):
///   gamma = 2 sqrt(exy^2 + eyz^2 + exz^2),
/// with the off-diagonal tensor components of the small strain; never negative. It depends on the
/// choice of axes: a stretch at 45 degrees to the axes contributes, the same stretch along an axis
/// does not.
struct OffDiagonalShear {
  static constexpr const char* formula = "2 sqrt(exy^2 + eyz^2 + exz^2)";
  static constexpr std::array<bool, 6> reads{false, false, false, true, true, true};
  /// Computes gamma [1] from a strain.
  /// @param strain tensor components xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
