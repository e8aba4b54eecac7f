// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/slider_track.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(SliderTrack, centre_moves_along_the_direction) {
  Case input = small_case();
  input.motion.direction = {0.6, 0.8};
  const auto centre = SliderTrack(input).centre(1e-3);
  EXPECT_NEAR(centre[0], 2.1e-3, 1e-17);
  EXPECT_NEAR(centre[1], 1.8e-3, 1e-17);
}

TEST(CanonicalPosition, mirrored_centres_share_one) {
  const Skin skin = small_case().skin;
  const auto a = canonical_position(skin, {1.5e-3, 0.8e-3}),
             b = canonical_position(skin, {3.5e-3, 1.2e-3});
  EXPECT_NEAR(a.centre[0], b.centre[0], 1e-17);
  EXPECT_NEAR(a.centre[1], b.centre[1], 1e-17);
  EXPECT_FALSE(a.reflect[0] || a.reflect[1]);
  EXPECT_TRUE(b.reflect[0] && b.reflect[1]);
  EXPECT_EQ(b.reflected({1, 2}), (std::array<double, 2>{-1, -2}));
}

} // namespace
} // namespace ionskin::mechanics
