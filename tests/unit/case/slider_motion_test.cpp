// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin {
namespace {

Motion rubbing() {
  Motion motion;
  motion.kind = MotionKind::reciprocating;
  motion.gap = 1e-3;
  motion.preload = 1e-6;
  motion.stroke = 2e-3;
  motion.touchdown = motion.lift = 0.5;
  motion.slide = 2;
  motion.return_ = 1;
  motion.strokes = 3;
  motion.dwell = 0.25;
  return motion;
}

Slider slider() {
  Slider result;
  result.start = {4e-3, 1e-3};
  return result;
}

TEST(SliderMotion, StrokesGoBackAndForthWithRestsBetweenThem) {
  const auto legs = motion_legs(rubbing(), slider());
  ASSERT_EQ(legs.size(), 8u); // touchdown, stroke, rest, stroke, rest, stroke, lift, return
  EXPECT_DOUBLE_EQ(legs[1].to[0], 6e-3);
  EXPECT_FALSE(legs[2].slides());
  EXPECT_TRUE(legs[2].touches());
  EXPECT_EQ(legs[3].direction(), (std::array<double, 2>{-1, 0}));
  EXPECT_DOUBLE_EQ(legs[6].from[0], 6e-3);
  EXPECT_EQ(legs[7].to, slider().start);
  EXPECT_DOUBLE_EQ(legs.back().end(), 8.5);
  EXPECT_DOUBLE_EQ(rubbing().cycle_duration(), 8.5);
}

TEST(SliderMotion, TheBoxHoldsTheWay) {
  EXPECT_EQ(motion_box(rubbing(), slider()).low, (std::array<double, 2>{4e-3, 1e-3}));
  EXPECT_EQ(motion_box(rubbing(), slider()).high, (std::array<double, 2>{6e-3, 1e-3}));
}

TEST(SliderMotion, AForceStandsForTheIndentation) {
  Motion motion = rubbing();
  motion.preload = 0;
  motion.preload_force = 2;
  const auto legs = motion_legs(motion, slider());
  EXPECT_EQ(legs[0].to_level, (SliderLevel{true, 2}));
  EXPECT_TRUE(legs[0].lands());
  EXPECT_TRUE(legs[6].leaves());
}

TEST(SliderMotion, ContactIsThePartOfALegBelowTheTopFace) {
  Motion motion;
  motion.kind = MotionKind::waypoints;
  motion.waypoints = {{0, {0, 0}, 3e-6, {}},
                      {4, {4e-3, 0}, -1e-6, {}},
                      {5, {4e-3, 0}, -2e-6, {}},
                      {6, {4e-3, 3e-3}, 2e-6, {}}};
  const auto legs = motion_legs(motion, {});
  EXPECT_EQ(legs[0].phase, Phase::touchdown);
  EXPECT_EQ(legs[1].phase, Phase::slide);
  EXPECT_EQ(legs[2].phase, Phase::lift);
  const ContactPart landing = contact_part(legs[0]), leaving = contact_part(legs[2]);
  EXPECT_DOUBLE_EQ(landing.begin, 3);
  EXPECT_DOUBLE_EQ(landing.duration, 1);
  EXPECT_DOUBLE_EQ(landing.from[0], 3e-3);
  EXPECT_EQ(landing.from_level.value, 0);
  EXPECT_DOUBLE_EQ(leaving.duration, 0.5);
  EXPECT_DOUBLE_EQ(leaving.to[1], 1.5e-3);
  const MotionBox box = motion_box(motion, {});
  EXPECT_EQ(box.low, (std::array<double, 2>{0, 0}));
  EXPECT_EQ(box.high, (std::array<double, 2>{4e-3, 3e-3}));
}

TEST(SliderMotion, FiguresAreTakenFromTheFirstSlide) {
  const auto legs = motion_legs(rubbing(), slider());
  EXPECT_EQ(&first_slide(legs), &legs[1]);
  Motion hold = rubbing();
  hold.stroke = 0;
  const auto held = motion_legs(hold, slider());
  EXPECT_EQ(&first_slide(held), &held[1]);
}

TEST(SliderMotion, RowsOfARecordedPathAreOneSlide) {
  Motion motion;
  motion.kind = MotionKind::waypoints;
  motion.waypoints = {{0, {0, 0}, 1e-3, {}},          {1, {0, 0}, -1e-6, {}},
                      {2, {1e-3, 0}, -1e-6, {}},      {3, {2e-3, 0.05e-3}, -1e-6, {}},
                      {5, {4e-3, 0.1e-3}, -1e-6, {}}, {6, {4e-3, 1e-3}, -1e-6, {}}};
  const auto legs = motion_legs(motion, {});
  EXPECT_EQ(&first_slide(legs), &legs[1]);
  const MotionLeg slide = whole_slide(legs);
  EXPECT_EQ(slide.begin, 1);
  EXPECT_EQ(slide.end(), 5);
  EXPECT_EQ(slide.to, legs[3].to);
  EXPECT_NEAR(slide_direction(legs)[1], 0.1 / std::hypot(4, 0.1), 1e-12);
  EXPECT_EQ(joined_slides(legs).size(), 3u);
  EXPECT_EQ(joined_slides(legs)[1].to, slide.to);
  // One that leads back to where it began is recognised by its first leg.
  std::vector<MotionLeg> turn;
  for (int i = 0; i <= 100; ++i) {
    const double from = 2 * M_PI * i / 100, to = 2 * M_PI * (i + 1) / 100;
    turn.push_back({Phase::slide,
                    0.1 * i,
                    0.1,
                    {std::cos(from), std::sin(from)},
                    {std::cos(to), std::sin(to)},
                    {false, -1e-6},
                    {false, -1e-6}});
  }
  EXPECT_EQ(slide_direction(turn), turn.front().direction());
}

} // namespace
} // namespace ionskin
