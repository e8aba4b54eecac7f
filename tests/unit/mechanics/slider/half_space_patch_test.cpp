// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/half_space_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Midpoint sums over a rectangle that does not hold the place.
PatchIntegrals midpoint_sums(double u0, double u1, double v0, double v1) {
  constexpr int count = 400;
  PatchIntegrals sum;
  const double du = (u1 - u0) / count, dv = (v1 - v0) / count;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double u = u0 + (i + 0.5) * du, v = v0 + (j + 0.5) * dv;
      const double r = std::hypot(u, v), area = du * dv;
      sum.inverse += area / r;
      sum.xx += area * u * u / (r * r * r);
      sum.yy += area * v * v / (r * r * r);
      sum.xy += area * u * v / (r * r * r);
      sum.x += area * u / (r * r);
      sum.y += area * v / (r * r);
    }
  }
  return sum;
}

TEST(HalfSpacePatch, AgreesWithSumsOverTheRectangle) {
  const PatchIntegrals found = patch_integrals(-0.7, 1.9, 0.4, 1.1),
                       expected = midpoint_sums(-0.7, 1.9, 0.4, 1.1);
  EXPECT_NEAR(found.inverse, expected.inverse, 1e-5);
  EXPECT_NEAR(found.xx, expected.xx, 1e-5);
  EXPECT_NEAR(found.yy, expected.yy, 1e-5);
  EXPECT_NEAR(found.xy, expected.xy, 1e-5);
  EXPECT_NEAR(found.x, expected.x, 1e-5);
  EXPECT_NEAR(found.y, expected.y, 1e-5);
}

TEST(HalfSpacePatch, HasTheKnownValueInTheMiddleOfASquare) {
  const PatchIntegrals middle = patch_integrals(-0.5, 0.5, -0.5, 0.5);
  EXPECT_NEAR(middle.inverse, 4 * std::asinh(1.0), 1e-14);
  EXPECT_NEAR(middle.xx, middle.yy, 1e-14);
  EXPECT_NEAR(middle.xy, 0, 1e-14);
  EXPECT_NEAR(middle.x, 0, 1e-14);
}

TEST(HalfSpacePatch, IsFiniteAtACornerAndOnAnEdge) {
  const PatchIntegrals corner = patch_integrals(0, 1, 0, 1);
  EXPECT_NEAR(corner.inverse, patch_integrals(-1, 1, -1, 1).inverse / 4, 1e-14);
  EXPECT_NEAR(corner.x, patch_integrals(0, 1, -1, 1).x / 2, 1e-14);
}

} // namespace
} // namespace ionskin::mechanics
