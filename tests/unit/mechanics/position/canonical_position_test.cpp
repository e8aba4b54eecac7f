// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/canonical_position.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(CanonicalPosition, mirrored_centres_share_one) {
  const Skin skin = small_case().skin;
  const auto a = canonical_position(skin, {1.5e-3, 0.8e-3}),
             b = canonical_position(skin, {3.5e-3, 1.2e-3});
  EXPECT_NEAR(a.centre[0], b.centre[0], 1e-17);
  EXPECT_NEAR(a.centre[1], b.centre[1], 1e-17);
  EXPECT_FALSE(a.reflect[0] || a.reflect[1]);
  EXPECT_TRUE(b.reflect[0] && b.reflect[1]);
  EXPECT_TRUE(same_place(skin, a.centre, b.centre));
  EXPECT_FALSE(same_place(skin, a.centre, {1.5e-3, 0.8001e-3}));
}

} // namespace
} // namespace ionskin::mechanics
