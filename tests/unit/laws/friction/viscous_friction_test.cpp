// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/viscous_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(ViscousFriction, IsInProportionToPressureAndSpeed) {
  const ViscousFriction law{0.3, 2e-3};
  EXPECT_DOUBLE_EQ(law.limit({1e6, 2e-4, 0.1}), 0.3e6);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 1e-4, 0.1}), 0.15e6);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 1e-4, 0.05}), 0.3e6);
  EXPECT_EQ(law.limit({-1e6, 1e-4, 0.1}), 0);
  EXPECT_EQ(law.limit({1e6, 0, 0}), 0);
}

TEST(ViscousFriction, SlopesAreThoseOfTheProduct) {
  const ViscousFriction law{0.3, 2e-3};
  EXPECT_DOUBLE_EQ(law.limit_slope({1e6, 1e-4, 0.1}), 0.15);
  EXPECT_DOUBLE_EQ(law.limit_slip_slope({1e6, 1e-4, 0.1}), 0.15e6 / 1e-4);
}

} // namespace
} // namespace ionskin::laws
