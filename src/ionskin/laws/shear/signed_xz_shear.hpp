// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::laws {

/// Engineering shear between the skin's length and its thickness, with its sign, docs/model.md
/// (10):
///   gamma = 2 exz = du_x/dz + du_z/dx.
/// Positive where the upper side is dragged towards +x. It is linear in the strain, tells forth
/// from back, keeps its sign under a reflection in y and changes it under one in x.
struct SignedXzShear {
  static constexpr const char* formula = "2 exz with its sign";
  static constexpr std::array<bool, 6> reads{false, false, false, false, true, false};
  /// The measure of a strain [1].
  /// @param strain xx, yy, zz, yz, xz, xy [1]
  static double at(const std::array<double, 6>& strain);
};

} // namespace ionskin::laws
