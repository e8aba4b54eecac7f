// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/elastic_law.hpp"

namespace ionskin::mechanics {

ElasticLaw isotropic_elasticity(const Material& material) {
  const double modulus = material.youngs_modulus, nu = material.poissons_ratio;
  return {modulus * nu / ((1 + nu) * (1 - 2 * nu)), modulus / (2 * (1 + nu))};
}

} // namespace ionskin::mechanics
