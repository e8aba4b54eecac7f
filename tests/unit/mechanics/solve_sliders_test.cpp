// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_sliders.hpp"

#include "ionskin/base/error.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ionskin::mechanics {
namespace {

std::string refusal_of(const std::vector<Case>& sliders) {
  base::Timers timers;
  try {
    solve_sliders(sliders, {}, timers);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(SolveSliders, RefusesSlidersThatMeet) {
  EXPECT_NE(refusal_of({small_case(), small_case()}).find("come within 0 mm of each other"),
            std::string::npos);
}

TEST(SolveSliders, RefusesCyclesOfOtherDurations) {
  Case longer = small_case();
  longer.motion.slide *= 2;
  EXPECT_NE(refusal_of({small_case(), longer}).find("need cycles of one duration"),
            std::string::npos);
}

TEST(SolveSliders, RefusesDrives) {
  Case driven = small_case();
  driven.motion.drive.stiffness = 1e3;
  EXPECT_NE(refusal_of({small_case(), driven}).find("slider 2 of 2 hangs on a drive"),
            std::string::npos);
}

TEST(DistanceOfSliders, IsThatOfTheirNearestPoints) {
  EXPECT_EQ(distance({0, 0}, {1, 1}, {1.5, 1}, {1, 1}), 0);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 1}, {5, 6}, {1, 1}), 5);
}

TEST(ForcePath, IsLinearBetweenInstants) {
  const ForcePath path{{0, 1}, {0, 1}, {{0, {0, 0}, {0, 0, 0}}, {2, {4, 0}, {8, 2, 0}}}};
  const ForcePath::Instant middle = path.at(0.5);
  EXPECT_DOUBLE_EQ(middle.centre[0], 1);
  EXPECT_DOUBLE_EQ(middle.force[0], 2);
  EXPECT_DOUBLE_EQ(path.at(3).force[1], 2);
}

} // namespace
} // namespace ionskin::mechanics
