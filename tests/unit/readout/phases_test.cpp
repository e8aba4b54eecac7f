// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/phases.hpp"

#include <gtest/gtest.h>

namespace ionskin::readout {
namespace {

Motion paper_motion() {
  Motion motion;
  motion.gap = 1e-3;
  motion.preload = 1e-6;
  motion.stroke = 6e-3;
  motion.touchdown = 0.5;
  motion.slide = 2;
  motion.lift = 0.5;
  motion.return_ = 1;
  motion.cycles = 3;
  return motion;
}

Slider paper_slider() {
  Slider slider;
  slider.start = {4.5e-3, 1e-3};
  return slider;
}

MotionInstant at(double time) {
  return MotionPhases(paper_motion(), paper_slider()).at(time);
}

TEST(Phases, ABoundaryBelongsToThePhaseThatEndsThere) {
  EXPECT_EQ(at(0).phase, "touchdown");
  EXPECT_EQ(at(0.5).phase, "touchdown");
  EXPECT_EQ(at(0.5 + 1e-6).phase, "slide");
  EXPECT_EQ(at(2.5).phase, "slide");
  EXPECT_EQ(at(3.0).phase, "lift");
  EXPECT_EQ(at(4.0).phase, "return");
  EXPECT_EQ(at(4.0).cycle, 1);
  EXPECT_EQ(at(4.0 + 1e-6).phase, "touchdown");
  EXPECT_EQ(at(4.0 + 1e-6).cycle, 2);
  EXPECT_EQ(at(12.0).cycle, 3);
  EXPECT_EQ(at(12.0).phase, "return");
}

TEST(Phases, RoundingOfEventTimesDoesNotMoveThemIntoTheNextPhase) {
  Motion motion = paper_motion();
  motion.touchdown = 0.1;
  motion.slide = 0.2;
  motion.lift = 0.3;
  motion.return_ = 0.4;
  const double rounded_end_of_slide = 1.0 + 0.1 + 0.2; // a hair above 1.3
  const MotionInstant end = MotionPhases(motion, paper_slider()).at(rounded_end_of_slide);
  EXPECT_EQ(end.cycle, 2);
  EXPECT_EQ(end.phase, "slide");
  const MotionInstant cycle_end = MotionPhases(motion, paper_slider()).at(1.0 + 4e-16);
  EXPECT_EQ(cycle_end.cycle, 1);
  EXPECT_EQ(cycle_end.phase, "return");
}

TEST(Phases, SliderFollowsThePrescribedMotionInEveryCycle) {
  for (double start : {0.0, 4.0, 8.0}) {
    EXPECT_NEAR(at(start + 0.25).centre[0], 4.5e-3, 1e-12);
    EXPECT_NEAR(at(start + 1.5).centre[0], 7.5e-3, 1e-12);
    EXPECT_NEAR(at(start + 2.75).centre[0], 10.5e-3, 1e-12);
    EXPECT_NEAR(at(start + 3.5).centre[0], 7.5e-3, 1e-12);
    EXPECT_NEAR(at(start + 4.0).centre[0], 4.5e-3, 1e-12);
  }
}

TEST(Phases, SlideAcrossTheTrackKeepsX) {
  Motion motion = paper_motion();
  motion.direction = {0, 1};
  EXPECT_EQ(MotionPhases(motion, paper_slider()).at(1.5).centre[0], 4.5e-3);
}

TEST(Phases, APhaseWithoutDurationIsPassedAtOnce) {
  Motion motion = paper_motion();
  motion.return_ = 0;
  EXPECT_NEAR(MotionPhases(motion, paper_slider()).at(1.5).centre[0], 7.5e-3, 1e-12);
  EXPECT_EQ(MotionPhases(motion, paper_slider()).at(3.0).phase, "lift");
  EXPECT_EQ(MotionPhases(motion, paper_slider()).at(3.1).cycle, 2);
}

TEST(Phases, ALevelIsGivenButForTheWayBetweenAHeightAndAForce) {
  EXPECT_EQ(at(0).level, (SliderLevel{false, 1e-3}));
  EXPECT_NEAR(at(0.25).level->value, 0.4995e-3, 1e-12);
  EXPECT_EQ(at(4.5).level, (SliderLevel{false, -1e-6}));
  Motion motion = paper_motion();
  motion.preload_force = 3;
  const MotionPhases phases(motion, paper_slider());
  EXPECT_EQ(phases.at(0).level, (SliderLevel{false, 1e-3}));
  EXPECT_FALSE(phases.at(0.25).level);
  EXPECT_EQ(phases.at(0.5).level, (SliderLevel{true, 3}));
  EXPECT_EQ(phases.at(5.5).level, (SliderLevel{true, 3}));
  EXPECT_FALSE(phases.at(2.75).level);
  EXPECT_EQ(phases.at(3.5).level, (SliderLevel{false, 1e-3}));
}

TEST(Phases, NamedInstants) {
  EXPECT_EQ(end_of_touchdown(paper_motion(), paper_slider()), 0.5);
  EXPECT_EQ(middle_of_slide(paper_motion(), paper_slider()), 1.5);
  EXPECT_EQ(end_of_slide(paper_motion(), paper_slider()), 2.5);
}

TEST(Phases, ASlideOfManyRowsEndsWithTheLastOne) {
  Motion recorded;
  recorded.kind = MotionKind::waypoints;
  recorded.waypoints = {{0, {1e-3, 1e-3}, -1e-6, {}},
                        {1, {2e-3, 1e-3}, -1e-6, {}},
                        {2, {3e-3, 1e-3}, -1e-6, {}},
                        {3, {3e-3, 1e-3}, 1e-3, {}}};
  EXPECT_EQ(middle_of_slide(recorded, {}), 1);
  EXPECT_EQ(end_of_slide(recorded, {}), 2);
}

} // namespace
} // namespace ionskin::readout
