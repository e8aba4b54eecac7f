// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/stribeck_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::laws {
namespace {

TEST(StribeckFriction, FallsFromStaticToKineticWithTheLaggedSpeed) {
  const StribeckFriction law{0.4, 0.3, 1e-3, 5e-3};
  EXPECT_DOUBLE_EQ(law.limit({1e6, 1e-3, 1e-3, 0}), 0.4e6);
  EXPECT_NEAR(law.limit({1e6, 0, 1e-3, 1e-3}), (0.3 + 0.1 / M_E) * 1e6, 1e-6);
  EXPECT_DOUBLE_EQ(law.limit({1e6, 0, 1e-3, 1}), 0.3e6);
  EXPECT_EQ(law.limit({-1e6, 0, 1e-3, 1}), 0);
  EXPECT_DOUBLE_EQ(law.limit_slope({1e6, 0, 1e-3, 0}), 0.4);
  EXPECT_EQ(law.limit_slope({-1e6, 0, 1e-3, 0}), 0);
}

} // namespace
} // namespace ionskin::laws
