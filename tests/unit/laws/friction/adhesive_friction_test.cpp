// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/adhesive_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(AdhesiveFriction, RubsByWhatPressesAlone) {
  const AdhesiveFriction law{0.3, 0.05, 1e5};
  EXPECT_DOUBLE_EQ(law.limit({2e6}), 0.6e6);
  EXPECT_EQ(law.limit({-1e4}), 0);
  EXPECT_DOUBLE_EQ(law.limit_slope({1}), 0.3);
  EXPECT_EQ(law.limit_slope({-1}), 0);
}

TEST(AdhesiveFriction, PartingTheFacesTakesTheWorkOfAdhesion) {
  const CohesiveZone zone = AdhesiveFriction{0.3, 0.05, 1e5}.adhesion();
  EXPECT_DOUBLE_EQ(zone.range, 1e-6);
  EXPECT_EQ(zone.tension(0), 1e5);
  EXPECT_EQ(zone.tension(-1e-9), 1e5);
  EXPECT_DOUBLE_EQ(zone.tension(0.25e-6), 0.75e5);
  EXPECT_EQ(zone.tension(2e-6), 0);
  constexpr int intervals = 1000;
  double work = 0;
  for (int i = 0; i < intervals; ++i) {
    work += zone.tension((i + 0.5) * zone.range / intervals) * zone.range / intervals;
  }
  EXPECT_NEAR(work, 0.05, 1e-12);
  EXPECT_NEAR(zone.binding_energy(0), 0.05, 1e-15);
  EXPECT_NEAR(zone.binding_energy(0.5e-6), 0.0125, 1e-15);
  EXPECT_EQ(zone.binding_energy(1.5e-6), 0);
}

TEST(AdhesiveFriction, PullsWithoutFrictionToo) {
  const LawValues values{{"work_of_adhesion", 0.05}, {"cohesive_strength", 1e5}};
  for (const double coefficient : {0.0, 0.3}) {
    const Friction law = friction("adhesive", coefficient, values);
    EXPECT_TRUE(law.adhesion.pulls());
    EXPECT_DOUBLE_EQ(law.limit({1e6}), coefficient * 1e6);
  }
  EXPECT_FALSE(friction("coulomb", 0.3, {}).adhesion.pulls());
}

} // namespace
} // namespace ionskin::laws
