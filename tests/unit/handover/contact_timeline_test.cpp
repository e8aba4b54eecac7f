// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_timeline.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::handover {
namespace {

class ContactTimelineTest : public testing::Test {
protected:
  Case input = small_case();
  mechanics::ContactSolution contact = synthetic_contact(input);
  ContactTimeline timeline{input, contact};
};

TEST_F(ContactTimelineTest, SamplesAscendAndHoldTheEvents) {
  const auto& times = timeline.sample_times();
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_EQ(std::adjacent_find(times.begin(), times.end()), times.end());
  EXPECT_DOUBLE_EQ(times.front(), 0);
  EXPECT_DOUBLE_EQ(times.back(), 4);
  for (const double event : timeline.event_times()) {
    EXPECT_TRUE(std::binary_search(times.begin(), times.end(), event)) << event;
  }
}

TEST_F(ContactTimelineTest, TouchesInTheLastPartOfTouchdown) {
  const double contact_time = 0.5 * 1000.0 / 1001.0;
  EXPECT_TRUE(timeline.at(contact_time).terms.empty());
  EXPECT_NEAR(timeline.at(0.5 * (contact_time + 0.5)).normal_force(), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(timeline.at(0.5).normal_force(), 1.0);
}

TEST_F(ContactTimelineTest, OnsetRunsThroughItsStatesIntoSteadySliding) {
  const double speed = 3e-3;
  EXPECT_NEAR(timeline.at(0.5 + 1e-6 / speed).normal_force(), 1.5, 1e-5);
  EXPECT_NEAR(timeline.at(0.5 + 3e-6 / speed).normal_force(), 1.9, 1e-4);
  const double join = timeline.join_time();
  EXPECT_NEAR(join, 0.5 + 5e-6 / speed, 1e-12);
  EXPECT_NEAR(timeline.at(join - 1e-9).normal_force(), timeline.at(join + 1e-9).normal_force(),
              1e-5);
  EXPECT_NEAR(timeline.at(0.5 + 1e-12).normal_force(), 1.0, 1e-6);
}

TEST_F(ContactTimelineTest, PassesThroughSteadySlidingAlongTheTrack) {
  const auto middle = timeline.at(1.5);
  EXPECT_NEAR(middle.centre[0], 7.5e-3, 1e-15);
  EXPECT_NEAR(middle.height, -1e-6, 1e-18);
  EXPECT_NEAR(middle.normal_force(), 2 + 9, 1e-10);
  EXPECT_NEAR(middle.tangential_force()[0], 0.3 * 11, 1e-10);
}

TEST_F(ContactTimelineTest, LiftsThroughItsStatesToNothing) {
  const double end = 2 + 36;
  const double duration = 0.5 / 1001; // the preload's part of lift-off
  EXPECT_NEAR(timeline.at(2.5).normal_force(), end, 1e-9);
  EXPECT_NEAR(timeline.at(2.5 + 0.25 * duration).normal_force(), 0.7 * end, 1e-9);
  EXPECT_NEAR(timeline.at(2.5 + 0.5 * duration).normal_force(), 0.4 * end, 1e-9);
  EXPECT_NEAR(timeline.at(2.5 + 0.75 * duration).normal_force(), 0.2 * end, 1e-9);
  EXPECT_TRUE(timeline.at(2.5 + duration).terms.empty());
}

TEST_F(ContactTimelineTest, ReturnsDetachedToTheStart) {
  EXPECT_DOUBLE_EQ(timeline.at(3.0).centre[0], 10.5e-3);
  EXPECT_NEAR(timeline.at(3.5).centre[0], 7.5e-3, 1e-15);
  EXPECT_NEAR(timeline.at(4.0).centre[0], 4.5e-3, 1e-15);
}

TEST_F(ContactTimelineTest, HeightFollowsThePrescribedMotion) {
  EXPECT_NEAR(timeline.at(0.25).height, 1e-3 - 0.5 * 1.001e-3, 1e-12);
  EXPECT_NEAR(timeline.at(1.5).height, -1e-6, 1e-12);
  EXPECT_NEAR(timeline.at(2.75).height, 1e-3 - 0.5 * 1.001e-3, 1e-12);
  EXPECT_NEAR(timeline.at(3.5).height, 1e-3, 1e-12);
}

TEST(ContactTimeline, ZeroStrokeHoldsTheTouchdownState) {
  Case input = small_case();
  input.motion.stroke = 0;
  auto contact = synthetic_press(input);
  add_lift_off(input, contact, 0.4);
  const ContactTimeline timeline(input, contact);
  EXPECT_DOUBLE_EQ(timeline.at(1.7).normal_force(), 1.0);
  EXPECT_DOUBLE_EQ(timeline.join_time(), 0.5);
}

TEST(ContactTimeline, ShortStrokeEndsWithinOnset) {
  Case input = small_case();
  input.motion.stroke = 3e-6;
  auto contact = synthetic_press(input);
  add_onset(input, contact);
  add_lift_off(input, contact, 0.9);
  const ContactTimeline timeline(input, contact);
  EXPECT_NEAR(timeline.at(0.5 + 2.0 / 3).normal_force(), 1.5, 1e-12);
  EXPECT_NEAR(timeline.at(2.5).normal_force(), 1.9, 1e-12);
  const double duration = 0.5 / 1001;
  EXPECT_NEAR(timeline.at(2.5 + 0.25 * duration).normal_force(), 0.5 * (1.9 + 0.9), 1e-9);
  EXPECT_NEAR(timeline.at(1.7).centre[0], 4.5e-3 + 1.8e-6, 1e-15);
  EXPECT_DOUBLE_EQ(timeline.join_time(), 2.5);
}

} // namespace
} // namespace ionskin::handover
