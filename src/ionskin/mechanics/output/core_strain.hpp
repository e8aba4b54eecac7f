// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

/// The field of the skin reflected along x and/or y: points reversed, shear signs flipped.
CoreStrain mirrored(CoreStrain strain, const std::array<bool, 2>& reflect);

/// Volume integral over the meshed core of 2 sqrt(exy^2 + eyz^2 + exz^2) from the points
/// of CoreStrain [m3].
double off_diagonal_shear_integral(const CoreStrain& strain, const mesh::MeshLines& lines,
                                   const std::array<std::size_t, 2>& core_z);

} // namespace ionskin::mechanics
