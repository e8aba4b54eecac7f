// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/onset_travel.hpp"
#include "small_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

MotionLeg slide(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  return {Phase::slide, 0, 1, from, to, {false, -1e-6}, {false, -1e-6}};
}

TEST(OnsetTravel, BeginsAtARestAndAtATurnAndGrowsUntilAllSlips) {
  SlidingContact slider = line().slider();
  const SliderLoad load{LoadKind::indentation, 1e-6};
  std::array<double, 2> place{2e-3, 1e-3};
  slider.step(1, place, load);
  OnsetTravel travel({}, false);
  const MotionLeg forth = slide(place, {3e-3, 1e-3});
  ASSERT_TRUE(travel.begin(forth, slider));
  const double first = travel.longest();
  int steps = 0;
  for (; !travel.is_over(forth, slider) && steps < 200; ++steps) {
    place[0] += travel.longest();
    slider.step(1e-3, place, load);
    travel.grow(slider);
  }
  EXPECT_GT(steps, 10);
  EXPECT_LT(steps, 100);
  EXPECT_GT(travel.longest(), 1.05 * first);
  EXPECT_FALSE(travel.begin(slide(place, {3e-3, 1.00001e-3}), slider)) << "goes on";
  EXPECT_TRUE(travel.begin(slide(place, {1e-3, 1e-3}), slider)) << "turns back";
  for (int i = 0; i < 40; ++i) {
    place[0] += 10e-6;
    slider.step(1e-3, place, load);
  }
  travel.rest();
  EXPECT_FALSE(travel.begin(forth, slider)) << "all of it still slips that way";
  EXPECT_TRUE(std::isinf(travel.longest()));
}

} // namespace
} // namespace ionskin::mechanics
