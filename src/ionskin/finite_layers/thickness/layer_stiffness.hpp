// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Calculates the stiffness matrix of one layer in plane strain: tractions on its two faces per
/// displacement of these faces, where displacements vary along the layer like a wave of number k,
/// U_r sin(k r) along the wave and w cos(k r) upwards.
///
/// The matrix has a closed form, made of waves that decay from either face (Kausel and Roesset
/// 1981, Bulletin of the Seismological Society of America 71, 1743; Kausel 2006, Fundamental
/// Solutions in Elastodynamics, Cambridge University Press). Below k t = 1/2, with the thickness t,
/// these waves become nearly identical, and a finite element of degree 8 replaces the closed form.
/// The two agree to 1e-10 there.
/// @param wave_number k, above 0 [1/m]
/// @returns rows and columns: bottom along the wave, bottom upwards, top along the wave, top
/// upwards [Pa/m]
Eigen::Matrix4d plane_strain_stiffness(const ElasticLayer& layer, double wave_number);

/// Stiffness of a layer against displacements U_t cos(k r) of its faces across the wave. The layer
/// is symmetric, so that both faces share the two entries.
struct AntiplaneStiffness {
  double own = 0;   ///< traction on a face per displacement of that face [Pa/m]
  double other = 0; ///< traction on a face per displacement of the opposite face, negative [Pa/m]
};
/// Calculates the stiffness of a layer against displacements across a wave, in closed form.
/// @param wave_number above 0 [1/m]
AntiplaneStiffness antiplane_stiffness(const ElasticLayer& layer, double wave_number);

} // namespace ionskin::finite_layers
