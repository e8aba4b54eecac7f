// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/regularised_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(RegularisedFriction, RisesOverTheSlipLengthAndStays) {
  const RegularisedFriction law{0.3, 1e-6};
  EXPECT_EQ(law.limit({1e6, 0, 0.1}), 0);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 0.5e-6, 0.1}), 0.15e6);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 5e-6, 0.1}), 0.3e6);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 0, 0}), 0.3e6); // of long sliding
  EXPECT_EQ(law.limit({-1e6, 5e-6, 0.1}), 0);
}

TEST(RegularisedFriction, SlopesAgreeWithFiniteDifferences) {
  const RegularisedFriction law{0.3, 1e-6};
  for (const double slip : {0.4e-6, 3e-6}) {
    const double by_slip =
        (law.limit({1e6, slip + 1e-9, 0.1}) - law.limit({1e6, slip - 1e-9, 0.1})) / 2e-9;
    EXPECT_NEAR(law.limit_slip_slope({1e6, slip, 0.1}), by_slip, 1e-6 * 0.3e12);
    const double by_normal =
        (law.limit({1e6 + 1, slip, 0.1}) - law.limit({1e6 - 1, slip, 0.1})) / 2;
    EXPECT_NEAR(law.limit_slope({1e6, slip, 0.1}), by_normal, 1e-7);
  }
  EXPECT_EQ(law.limit_slip_slope({-1e6, 0, 0.1}), 0);
}

} // namespace
} // namespace ionskin::laws
