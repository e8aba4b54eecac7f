// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/elastic_law.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(ElasticLaw, returns_youngs_modulus_and_poissons_ratio) {
  const Material material{"polymer", 249e6, 0.49};
  const ElasticLaw law = isotropic_elasticity(material);
  const double lambda = law.lame_lambda, mu = law.shear_modulus;
  EXPECT_NEAR(mu * (3 * lambda + 2 * mu) / (lambda + mu), 249e6, 1e-3);
  EXPECT_NEAR(lambda / (2 * (lambda + mu)), 0.49, 1e-14);
}

TEST(ElasticLaw, oedometric_modulus_of_the_baseline_core) {
  EXPECT_NEAR(isotropic_elasticity({"polymer", 249e6, 0.49}).oedometric_modulus(), 4.261e9, 0.5e6);
}

} // namespace
} // namespace ionskin::mechanics
