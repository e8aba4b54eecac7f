// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/coulomb_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(CoulombFriction, LimitIsProportionalToPressureAndZeroInTension) {
  const CoulombFriction law{0.3};
  EXPECT_DOUBLE_EQ(law.limit({2e6, 1e-6, 0.1}), 0.6e6);
  EXPECT_EQ(law.limit({-2e6, 1e-6, 0.1}), 0.0);
  EXPECT_DOUBLE_EQ(law.limit({2e6, 5e-6, 0.01}), law.limit({2e6, 1e-6, 0.1})); // rate-independent
}

TEST(CoulombFriction, SlopeAgreesWithFiniteDifferences) {
  const CoulombFriction law{0.3};
  for (const double traction : {-1e6, 1e6}) {
    const double difference =
        (law.limit({traction + 1, 0, 0}) - law.limit({traction - 1, 0, 0})) / 2;
    EXPECT_NEAR(law.limit_slope({traction, 0, 0}), difference, 1e-9);
  }
}

TEST(FrictionLaws, KeepTheirNameCoefficientAndLimit) {
  const Friction coulomb = friction("coulomb", 0.3, {});
  EXPECT_EQ(coulomb.law, "coulomb");
  EXPECT_EQ(coulomb.coefficient, 0.3);
  EXPECT_DOUBLE_EQ(coulomb.limit({2e6, 1e-6, 0.1}), 0.6e6);
  EXPECT_DOUBLE_EQ(coulomb.limit_slope({2e6, 1e-6, 0.1}), 0.3);
}

} // namespace
} // namespace ionskin::laws
