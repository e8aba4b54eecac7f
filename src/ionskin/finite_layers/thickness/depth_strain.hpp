// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/layer_field.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// A place through the thickness of a skin.
struct DepthLevel {
  std::size_t layer = 0;
  LayerHeight height;
};

/// Strain that a wave of tractions on the top face makes at a level, over a traction along the
/// wave, one upwards and one across it [1/Pa].
struct DepthStrain {
  double stretch_by_along = 0, stretch_by_normal = 0; ///< k U_r
  double rise_by_along = 0, rise_by_normal = 0;       ///< w'
  double shear_by_along = 0, shear_by_normal = 0;     ///< U_r' - k w
  double twist = 0;                                   ///< k U_t
  double across = 0;                                  ///< U_t'
};

/// Strains in closed form through all layers on their rigid base.
/// @param wave_number above 0 [1/m]
std::vector<DepthStrain> depth_strain(const std::vector<ElasticLayer>& layers, double wave_number,
                                      const std::vector<DepthLevel>& levels);

} // namespace ionskin::finite_layers
