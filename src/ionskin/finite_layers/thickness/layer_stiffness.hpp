// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Stiffness of one layer against displacements of its two faces that vary along the layer like a
/// wave of number k [1/m]: U_r sin(k r) along the wave, w cos(k r) upwards.
///
/// In closed form, from waves that decay from either face (Kausel and Roesset 1981, Bulletin of the
/// Seismological Society of America 71, 1743; Kausel 2006, Fundamental Solutions in Elastodynamics,
/// Cambridge University Press). Below k t = 1/2 these become alike, and a finite element of degree
/// 8 takes their place: the two agree to 1e-10 there.
/// @param wave_number above 0 [1/m]
/// @returns tractions on the bottom (along, upwards) and the top over their displacements [Pa/m]
Eigen::Matrix4d plane_strain_stiffness(const ElasticLayer& layer, double wave_number);

/// Stiffness of a layer across the wave, U_t cos(k r): traction on the bottom and the top over
/// their displacement [Pa/m].
struct AntiplaneStiffness {
  double own = 0;   ///< of a face over its own displacement [Pa/m]
  double other = 0; ///< over that of the other face, negative [Pa/m]
};
AntiplaneStiffness antiplane_stiffness(const ElasticLayer& layer, double wave_number);

} // namespace ionskin::finite_layers
