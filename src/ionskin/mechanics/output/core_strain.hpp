// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

/// Reflects a strain field along x, along y or along both: points come in the opposite order, and
/// shear components change their signs.
/// @param reflect whether along x and along y
CoreStrain mirrored(CoreStrain strain, const std::array<bool, 2>& reflect);

/// Integral of 2 sqrt(exy^2 + eyz^2 + exz^2) over the meshed part of the core [m3], from the points
/// of `CoreStrain`.
/// @param lines mesh of the skin
/// @param core_z first and one-past-last element of the core along z
double off_diagonal_shear_integral(const CoreStrain& strain, const mesh::MeshLines& lines,
                                   const std::array<std::size_t, 2>& core_z);

} // namespace ionskin::mechanics
