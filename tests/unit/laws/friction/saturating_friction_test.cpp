// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/saturating_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(SaturatingFriction, IsCoulombsAtLowPressureAndTheStrengthAtHigh) {
  const SaturatingFriction law{0.3, 4e6, 2};
  EXPECT_NEAR(law.limit({1e3}), 300, 1e-3);
  EXPECT_NEAR(law.limit({1e12}), 4e6, 1);
  EXPECT_EQ(law.limit({-1e6}), 0);
  EXPECT_NEAR(SaturatingFriction({0.3, 4e6, 20}).limit({1e300}), 4e6, 1); // no overflow
}

TEST(SaturatingFriction, SlopeAgreesWithFiniteDifferences) {
  const SaturatingFriction law{0.3, 4e6, 3};
  for (const double traction : {-1e6, 1e6, 2e7}) {
    const double difference = (law.limit({traction + 1}) - law.limit({traction - 1})) / 2;
    EXPECT_NEAR(law.limit_slope({traction}), difference, 1e-7);
  }
}

} // namespace
} // namespace ionskin::laws
