// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::handover {

/// Engineering shear between the skin's length and its thickness, with its sign:
///   gamma = 2 exz = du_x/dz + du_z/dx.
/// Positive where the upper side is dragged towards +x. It is linear in the strain, tells forth
/// from back, keeps its sign under a reflection in y and changes it under one in x.
/// @param strain xx, yy, zz, yz, xz, xy [1]
double signed_xz_shear(const std::array<double, 6>& strain);

} // namespace ionskin::handover
