// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/anisotropic_friction.hpp"

#include <gtest/gtest.h>

namespace ionskin::laws {
namespace {

TEST(AnisotropicFriction, LimitIsThatAlongXAndTheRatioThatAcross) {
  const AnisotropicFriction law{0.4, 0.1};
  EXPECT_DOUBLE_EQ(law.limit({1e6}), 0.4e6);
  EXPECT_DOUBLE_EQ(law.across(), 0.25);
  EXPECT_EQ(law.limit({-1e6}), 0);
  EXPECT_EQ(law.limit_slope({-1e6}), 0);
}

TEST(AnisotropicFriction, WithoutCoefficientIsNoFriction) {
  const Friction none = friction("anisotropic", 0, {{"transverse_friction", 0.3}});
  EXPECT_EQ(none.limit({1e6}), 0);
  EXPECT_EQ(none.across, 1);
}

} // namespace
} // namespace ionskin::laws
