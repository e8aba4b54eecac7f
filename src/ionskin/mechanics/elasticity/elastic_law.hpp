// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// Isotropic linear elasticity, docs/model.md (3): stress = lambda tr(strain) I + 2 mu strain.
struct ElasticLaw {
  double lame_lambda = 0;   ///< [Pa]
  double shear_modulus = 0; ///< mu [Pa]

  /// Stiffness against strain along one direction with both others held [Pa].
  double oedometric_modulus() const { return lame_lambda + 2 * shear_modulus; }
};

/// lambda = E nu / ((1 + nu)(1 - 2 nu)), mu = E / (2 (1 + nu)).
ElasticLaw isotropic_elasticity(const Material& material);

} // namespace ionskin::mechanics
