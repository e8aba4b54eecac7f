// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "largest_difference.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

/// The motion of the small case as waypoints, each leg in so many rows.
Case in_rows(int rows) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-3, {}}, {0.5, {1.5e-3, 1e-3}, -1e-6, {}}};
  for (int i = 1; i <= rows; ++i) {
    const double part = static_cast<double>(i) / rows;
    input.motion.waypoints.push_back({0.5 + 2 * part, {1.5e-3 + 2e-3 * part, 1e-3}, -1e-6, {}});
  }
  input.motion.waypoints.push_back({3, {3.5e-3, 1e-3}, 1e-3, {}});
  return input;
}

TEST(SteppedMotion, IsTheSameInAnyNumberOfRows) {
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const Case input = small_case();
  const ContactSolution stroke = solve_contact(input, options, timers);
  const ContactState& landed = *nearest(stroke, 0.5).state;
  const ContactState end =
      solve_steady_sliding(input, {input.motion.stroke}, options, timers).front();
  for (const int rows : {1, 500}) {
    const ContactSolution stepped = solve_contact(in_rows(rows), options, timers);
    EXPECT_LT(stepped.stepped.size(), 200u);
    EXPECT_LT(stepped.worst_complementarity_residual, 1e-6);
    const SteppedInstant &pressed = nearest(stepped, 0.5), &slid = nearest(stepped, 2.5);
    EXPECT_EQ(pressed.time, 0.5);
    EXPECT_NEAR(pressed.state->normal_force, landed.normal_force, 1e-6 * landed.normal_force);
    EXPECT_EQ(slid.time, 2.5);
    EXPECT_NEAR(slid.state->normal_force, end.normal_force, 1e-5 * end.normal_force);
    EXPECT_LT(largest_difference(core_strain(*slid.state).component[4], end.strain.component[4]),
              1e-4);
    EXPECT_EQ(stepped.stepped_events.size(), 4u); // lands, slides, lifts, leaves
    EXPECT_EQ(stepped.stepped_onsets.size(), 1u);
    EXPECT_EQ(stepped.stepped.back().state, nullptr);
    EXPECT_NEAR(stepped.stepped_events.back(), 2.5 + 0.5 / 1001, 1e-12);
  }
}

TEST(SteppedMotion, LandsAndLeavesByForceOnTheWay) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                            {1, {2.0e-3, 1e-3}, {}, 5.0},
                            {2, {3.0e-3, 1e-3}, {}, 8.0},
                            {3, {3.5e-3, 1e-3}, 1e-6, {}}};
  base::Timers timers;
  ContactOptions options;
  const ContactSolution solution = solve_contact(input, options, timers);
  EXPECT_NEAR(nearest(solution, 1).state->normal_force, 5, 1e-6);
  EXPECT_NEAR(nearest(solution, 2).state->normal_force, 8, 1e-6);
  EXPECT_NEAR(nearest(solution, 2).height, -nearest(solution, 2).state->indentation, 1e-12);
  EXPECT_GT(solution.stepped_events.front(), 0);
  EXPECT_LT(solution.stepped_events.front(), 1);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
}

TEST(SteppedMotion, RoundSlidersLandWhileTheyMove) {
  for (const char* shape : {"sphere", "cylinder"}) {
    Case input = small_case();
    input.slider.shape = shape;
    input.slider.parameters["radius"] = 8e-3;
    input.motion.kind = MotionKind::waypoints;
    input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                              {1, {2.5e-3, 1e-3}, -1e-6, {}},
                              {2, {3.0e-3, 1e-3}, 1e-6, {}}};
    base::Timers timers;
    ContactOptions options;
    const ContactSolution solution = solve_contact(input, options, timers);
    EXPECT_LT(solution.worst_complementarity_residual, 1e-6) << shape;
    ASSERT_EQ(solution.stepped_events.size(), 2u) << shape; // lands and leaves
    EXPECT_NEAR(solution.stepped_events.front(), 0.5, 0.01) << shape;
    EXPECT_NEAR(solution.stepped_events.back(), 1.5, 0.01) << shape;
    // All of it slips as soon as it touches.
    const ContactState& pressed = *nearest(solution, 1).state;
    EXPECT_GT(pressed.normal_force, 0) << shape;
    EXPECT_NEAR(pressed.tangential_force[0], input.contact.friction * pressed.normal_force,
                1e-6 * pressed.normal_force)
        << shape;
  }
}

TEST(SteppedMotion, RubsByAFifthOfAMicrometreInClosedLoops) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {2e-3, 1e-3}, 1e-6, {}}, {0.1, {2e-3, 1e-3}, -1e-6, {}}};
  for (int i = 1; i <= 120; ++i) {
    input.motion.waypoints.push_back(
        {0.1 + 0.01 * i, {2e-3 + 0.2e-6 * std::sin(2 * M_PI * i / 40), 1e-3}, -1e-6, {}});
  }
  input.output.fields = {0.6, 0.8, 1.0}; // are passed
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const ContactSolution solution = solve_contact(input, options, timers);
  // Every turn after the first rise is as the one before.
  const auto force = [&](double time) {
    return nearest(solution, time).state->tangential_force[0];
  };
  EXPECT_NEAR(force(0.6), force(1.0), 1e-3 * std::abs(force(0.6)));
  EXPECT_NEAR(force(0.8), -force(1.0), 0.1 * std::abs(force(0.6)));
  EXPECT_GT(nearest(solution, 0.6).state->stick_fraction, 0);
}

TEST(SteppedMotion, TakesStrokesUnderLawsOfSpeedAndRests) {
  Case input = small_case();
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 2;
  input.motion.dwell = 1;
  input.contact.law = "viscous";
  input.contact.parameters = {{"reference_speed", 1e-3}};
  base::Timers timers;
  ContactOptions options;
  const ContactSolution solution = solve_contact(input, options, timers);
  const auto ratio = [&](double time) {
    const ContactState& state = *nearest(solution, time).state;
    return state.tangential_force[0] / state.normal_force;
  };
  EXPECT_NEAR(ratio(1.5), 0.3, 1e-3); // 1 mm/s
  EXPECT_NEAR(ratio(3.5), 0.0, 1e-3); // relaxed in the rest
  EXPECT_NEAR(ratio(4.5), -0.3, 1e-3);
  EXPECT_EQ(nearest(solution, 1.5).state->stick_fraction, 0);
}

} // namespace
} // namespace ionskin::mechanics
