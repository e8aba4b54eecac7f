// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/leg_levels.hpp"
#include "small_line.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

constexpr std::array<double, 2> spot{2e-3, 1e-3};

MotionLeg leg(const SliderLevel& from, const SliderLevel& to) {
  return {Phase::touchdown, 0, 1, spot, spot, from, to};
}

TEST(LegLevels, OfHeightsTouchWhereTheSliderIsBelowTheSkin) {
  const SlidingContact above = line().slider();
  const LegLevels down = leg_levels(leg({false, 3e-6}, {false, -1e-6}), above, spot, 1);
  EXPECT_DOUBLE_EQ(down.begin, 0.75);
  EXPECT_EQ(down.end, 1);
  EXPECT_TRUE(down.presses());
  EXPECT_EQ(down.load(1).kind, LoadKind::indentation);
  EXPECT_DOUBLE_EQ(down.load(1).value, 1e-6);
  const LegLevels up = leg_levels(leg({false, -1e-6}, {false, 3e-6}), above, spot, 1);
  EXPECT_DOUBLE_EQ(up.end, 0.25);
  EXPECT_TRUE(up.leaves());
  EXPECT_EQ(up.load(up.end).value, 0);
  EXPECT_EQ(*up.height(1), 3e-6);
}

TEST(LegLevels, OfForcesHaveNoHeightsAndAreThoseOfTheMeshedPart) {
  const LegLevels pulled = leg_levels(leg({true, 4}, {true, 2}), line().slider(), spot, 0.5);
  EXPECT_FALSE(pulled.presses());
  EXPECT_FALSE(pulled.height(0.5));
  EXPECT_EQ(pulled.load(0.5).kind, LoadKind::force);
  EXPECT_DOUBLE_EQ(pulled.load(0.5).value, 1.5);
}

TEST(LegLevels, FromAHeightToAForceGoToWhereItIsCarried) {
  const SlidingContact above = line().slider();
  const LegLevels landing = leg_levels(leg({false, 1e-6}, {true, 5}), above, spot, 1);
  EXPECT_FALSE(above.in_contact()) << "only tried out";
  EXPECT_EQ(landing.load(1).kind, LoadKind::force);
  EXPECT_EQ(landing.load(1).value, 5);
  SlidingContact pressed = line().slider();
  pressed.step(1, spot, {LoadKind::indentation, -landing.to});
  EXPECT_NEAR(total_normal_force(pressed.state().force), 5, 1e-7);
}

} // namespace
} // namespace ionskin::mechanics
