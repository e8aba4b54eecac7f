// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/contact_solution.hpp"
#include "ionskin/mechanics/elastic_space.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Strain at the 2x2x2 Gauss points of the element rows [core_z[0], core_z[1]).
/// @param displacement shape [unknowns, states] [m]
/// @return one field per state
std::vector<CoreStrain> core_strain(const ElasticSpace& space, const mesh::MeshLines& lines,
                                    const std::array<std::size_t, 2>& core_z,
                                    const linear_algebra::DenseMatrix& displacement);

/// The field of the skin reflected along x and/or y: points reversed, shear signs flipped.
CoreStrain mirrored(const CoreStrain& strain, const std::array<bool, 2>& reflect);

/// Volume integral over the meshed core of 2 sqrt(exy^2 + eyz^2 + exz^2) by 2x2x2 Gauss points
/// [m3].
double off_diagonal_shear_integral(const CoreStrain& strain, const mesh::MeshLines& lines,
                                   const std::array<std::size_t, 2>& core_z);

} // namespace ionskin::mechanics
