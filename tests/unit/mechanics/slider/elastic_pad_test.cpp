// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/elastic_pad.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

TEST(ElasticPad, IsALayerInCompressionAndShearUnderLongWaves) {
  constexpr double depth = 1e-3;
  for (const double nu : {0.0, 0.3, 0.45}) {
    const WaveCompliance wave = wave_compliance(depth, nu);
    EXPECT_NEAR(wave.normal / depth, (1 - 2 * nu) / (2 * (1 - nu)), 1e-4) << nu; // G over M
    EXPECT_NEAR(wave.along / depth, 1, 1e-4) << nu;
    EXPECT_NEAR(wave.across / depth, 1, 1e-4) << nu;
  }
  // An incompressible layer has to flow: u = p k^2 H^3 / (3 G).
  EXPECT_NEAR(wave_compliance(depth, 0.5).normal / (depth * depth * depth), 1.0 / 3, 1e-3);
}

TEST(ElasticPad, IsAHalfSpaceUnderShortWaves) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    const WaveCompliance wave = wave_compliance(12, nu);
    EXPECT_NEAR(wave.normal, 1 - nu, 1e-6);
    EXPECT_NEAR(wave.along, 1 - nu, 1e-6);
    EXPECT_NEAR(wave.across, 1, 1e-6);
    EXPECT_NEAR(wave.mixed, (1 - 2 * nu) / 2, 1e-6);
  }
}

TEST(ElasticPad, RestsFarFromAForce) {
  for (const double nu : {0.2, 0.4}) {
    const PadStiffening pad(nu);
    for (const double distance : {15.0, 38.0}) {
      const PadStiffening::Values stiffer = pad.at(distance);
      EXPECT_NEAR(stiffer.normal * distance, 1 - nu, 1e-4) << distance;
      EXPECT_NEAR(stiffer.isotropic * distance, (2 - nu) / 2, 1e-4) << distance;
      EXPECT_NEAR(stiffer.deviatoric * distance, nu / 2, 1e-4) << distance;
      EXPECT_NEAR(stiffer.radial * distance, (1 - 2 * nu) / 2, 1e-4) << distance;
      EXPECT_EQ(pad.at(45).normal, (1 - nu) / 45);
    }
  }
}

TEST(ElasticPad, GivesUnderAWidePressureAsALayerDoes) {
  constexpr double nu = 0.3, step = 1e-3;
  const PadStiffening pad(nu);
  double normal = 0, tangential = 0; // integrals of distance times the pad's own kernels
  for (double r = step / 2; r < 20; r += step) {
    normal += step * r * ((1 - nu) / r - pad.at(r).normal);
    tangential += step * r * ((2 - nu) / 2 / r - pad.at(r).isotropic);
  }
  EXPECT_NEAR(normal, (1 - 2 * nu) / (2 * (1 - nu)), 2e-3);
  EXPECT_NEAR(tangential, 1, 2e-3);
}

} // namespace
} // namespace ionskin::mechanics
