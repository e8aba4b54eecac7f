// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/friction_law.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(FrictionLaw, IsProportionalWhereTheLimitIsACoefficientTimesThePressure) {
  EXPECT_TRUE(is_proportional(friction("coulomb", 0.3, {})));
  EXPECT_TRUE(is_proportional(friction("anisotropic", 0.3, {{"transverse_friction", 0.1}})));
  EXPECT_TRUE(is_proportional(friction("viscous", 0, {{"reference_speed", 0.01}})));
  EXPECT_FALSE(is_proportional(friction("saturating", 0.3, {{"strength", 4e6}, {"sharpness", 2}})));
  EXPECT_FALSE(is_proportional(friction("regularised", 0.3, {{"slip_length", 1e-6}})));
  EXPECT_FALSE(is_proportional(friction("viscous", 0.3, {{"reference_speed", 0.01}})));
  EXPECT_FALSE(is_proportional(friction(
      "stribeck", 0.3, {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 5e-3}})));
}

TEST(FrictionLaw, IsNotProportionalWhereTheCoefficientChangesAtAnyPressure) {
  for (const double change : {3e2, 3e5, 3e10}) {
    Friction softening = friction("coulomb", 0.3, {});
    softening.limit = [change](const FrictionArguments& at) {
      return (at.normal_traction < change ? 0.3 : 0.2) * at.normal_traction;
    };
    EXPECT_FALSE(is_proportional(softening)) << change;
  }
}

} // namespace
} // namespace ionskin::laws
