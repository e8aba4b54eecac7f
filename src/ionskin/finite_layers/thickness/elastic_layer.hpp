// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Flat layer of an isotropic linear elastic material, docs/model.md (3), bonded to its neighbours.
struct ElasticLayer {
  double lame_lambda = 0;   ///< [Pa]
  double shear_modulus = 0; ///< mu [Pa]
  double thickness = 0;     ///< [m]

  double poissons_ratio() const { return lame_lambda / (2 * (lame_lambda + shear_modulus)); }
  bool operator==(const ElasticLayer&) const = default;
  /// Oedometric modulus lambda + 2 mu: normal stress per strain in one direction while the other
  /// two directions do not strain [Pa].
  double oedometric_modulus() const { return lame_lambda + 2 * shear_modulus; }
};

/// Makes a layer from Young's modulus E and Poisson's ratio nu of a material: lambda = E nu / ((1 +
/// nu)(1 - 2 nu)), mu = E / (2 (1 + nu)).
/// @param thickness [m]
ElasticLayer elastic_layer(const Material& material, double thickness);
/// Makes the elastic layers of a skin, bottom to top.
std::vector<ElasticLayer> elastic_layers(const Skin& skin);

} // namespace ionskin::finite_layers
