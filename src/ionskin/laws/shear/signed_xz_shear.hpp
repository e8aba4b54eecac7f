// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Shear measure `signed-xz`, the engineering shear strain in the plane of length (x) and thickness
/// (z), with its sign, docs/model.md (10):
///   gamma = 2 exz = du_x/dz + du_z/dx.
/// It is positive where the upper side is dragged towards +x. It is linear in the strain,
/// distinguishes sliding along +x from sliding along -x, and changes sign under a reflection in x
/// but not in y.
struct SignedXzShear {
  static constexpr const char* formula = "2 exz with its sign";
  static constexpr std::array<bool, 6> reads{false, false, false, false, true, false};
  /// Computes gamma [1] from a strain.
  /// @param strain tensor components xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
