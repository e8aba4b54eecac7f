// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/layer_field.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// Position through the thickness of a skin.
struct DepthLevel {
  std::size_t layer = 0; ///< index, counted from the bottom
  LayerHeight height;
};

/// Amplitudes of the strain at one level, per unit amplitude of a traction on the top face that
/// varies along the face like a wave of number k [1/Pa]. `along` is a traction along the wave,
/// `normal` one upwards; `twist` and the member `across` belong to a traction across the wave.
/// Displacements have the amplitudes U_r along the wave, U_t across it and w upwards; a prime is
/// the derivative upwards, docs/model.md (58).
struct DepthStrain {
  double stretch_by_along = 0, stretch_by_normal = 0; ///< k U_r, stretch along the wave
  double rise_by_along = 0, rise_by_normal = 0;       ///< w', stretch through the thickness
  double shear_by_along = 0, shear_by_normal = 0;     ///< U_r' - k w, shear angle along the wave
  double twist = 0;                                   ///< k U_t, shear within the plane of the face
  double across = 0;                                  ///< U_t', shear angle across the wave
};

/// Calculates the strain at each level in closed form, for all layers on their rigid base.
/// @param layers bottom to top
/// @param wave_number k, above 0 [1/m]
/// @param levels positions through the thickness
/// @returns one entry per level
std::vector<DepthStrain> depth_strain(const std::vector<ElasticLayer>& layers, double wave_number,
                                      const std::vector<DepthLevel>& levels);

} // namespace ionskin::finite_layers
