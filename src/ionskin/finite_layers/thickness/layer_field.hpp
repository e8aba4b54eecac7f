// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

#include <optional>

namespace ionskin::finite_layers {

/// Height above the bottom of a layer [m]. Empty stands for the mean through the thickness of the
/// layer.
using LayerHeight = std::optional<double>;

/// Calculates the plane-strain displacement inside a layer under a wave from the displacements of
/// its two faces. Rows: U_r, U_r', w, w', with U_r along the wave [m], w upwards [m] and primes for
/// the derivative upwards. Columns: bottom face along the wave and upwards, then top face along the
/// wave and upwards [m]. Entries are therefore [1] for displacements and [1/m] for their
/// derivatives.
/// @param wave_number [1/m]
Eigen::Matrix4d plane_strain_field(const ElasticLayer& layer, double wave_number,
                                   LayerHeight height);

/// Calculates the displacement inside a layer across a wave from the displacements of its two
/// faces. Rows: U_t across the wave [1] and its derivative upwards U_t' [1/m]. Columns: U_t of the
/// bottom face and of the top face.
/// @param wave_number above 0 [1/m]
Eigen::Matrix2d antiplane_field(const ElasticLayer& layer, double wave_number, LayerHeight height);

} // namespace ionskin::finite_layers
