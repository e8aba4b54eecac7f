// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::mechanics {
namespace {

ContactSolution path_of(Case input) {
  settle_pose(input);
  base::Timers timers;
  return solve_contact(input, ContactOptions{}, timers);
}

/// A ball that is pressed, and then brought to other angles in place.
Case brought_to(const shapes::Pose& pose) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 4e-3;
  input.slider.size = {8e-3, 8e-3};
  input.motion.kind = MotionKind::waypoints;
  const std::array<double, 2> place{2.5e-3, 1e-3};
  input.motion.waypoints = {{0, place, 1e-6, {}}, {0.5, place, -2e-6, {}}, {1, place, -2e-6, {}}};
  Waypoint& last = input.motion.waypoints.back();
  last.roll = pose.roll;
  last.pitch = pose.pitch;
  last.yaw = pose.yaw;
  return input;
}

TEST(Turning, ABallThatSpinsMakesATorqueAgainstItsTurnUpToThatOfFullSlip) {
  const ContactSolution left = path_of(brought_to({0, 0, 0.5})),
                        right = path_of(brought_to({0, 0, -0.5}));
  const ContactState &end = *left.stepped.back().state, &other = *right.stepped.back().state;
  EXPECT_FALSE(left.mesh.half_model());
  EXPECT_NEAR(end.moment[2], -other.moment[2], 1e-9 * std::abs(end.moment[2]));
  double largest = 0; // of friction that slips everywhere around the centre
  for (std::size_t j = 0; j + 1 < left.cell_lines_y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < left.cell_lines_x.size(); ++i) {
      const std::size_t cell = i + j * (left.cell_lines_x.size() - 1);
      const double dx = left.cell_lines_x[i + 1] - left.cell_lines_x[i],
                   dy = left.cell_lines_y[j + 1] - left.cell_lines_y[j],
                   x = left.cell_lines_x[i] + dx / 2, y = left.cell_lines_y[j] + dy / 2;
      largest += 0.3 * end.normal_traction[cell] * dx * dy * std::hypot(x, y);
    }
  }
  EXPECT_GT(end.moment[2], 0); // on the skin, with the turn
  EXPECT_NEAR(end.moment[2], largest, 1e-3 * largest);
  EXPECT_LT(std::hypot(end.tangential_force[0], end.tangential_force[1]), 1e-6 * end.normal_force);
  EXPECT_LT(left.worst_complementarity_residual, 1e-6);
  EXPECT_GE(left.stepped_events.size(), 2u); // lands, begins to turn
}

TEST(Turning, ABallThatIsPitchedMovesItsPressureToTheFront) {
  const double pitch = 0.05, arm = 4e-3 * std::tan(pitch) / std::hypot(1, std::tan(pitch));
  Case input = brought_to({0, pitch, 0});
  input.numerics.mesh_refinement = 1;
  const ContactSolution solution = path_of(input);
  const ContactState& end = *solution.stepped.back().state;
  const double across = solution.cell_lines_x[1] - solution.cell_lines_x[0];
  EXPECT_TRUE(solution.mesh.half_model()); // it stays in the plane of symmetry
  EXPECT_NEAR(end.moment[1] / end.normal_force, arm, 0.5 * across);
  EXPECT_NEAR(end.indentation, 2e-6, 1e-12); // of the lowest point, wherever it is
  const ContactState& before = *nearest(solution, 0.5).state;
  EXPECT_NEAR(end.normal_force, before.normal_force, 0.05 * before.normal_force);
}

TEST(Turning, WhatTurnsInTheAirLandsWithoutSlip) {
  Case input = brought_to({});
  for (std::size_t i = 1; i < 3; ++i) {
    input.motion.waypoints[i].yaw = 1.0;
  }
  input.motion.waypoints[0].yaw = 0.0;
  input.motion.waypoints.insert(input.motion.waypoints.begin() + 1,
                                {0.25, input.motion.waypoints[0].position, 0.0, {}});
  input.motion.waypoints[1].yaw = 1.0;
  const ContactSolution solution = path_of(input);
  const ContactState& end = *solution.stepped.back().state;
  EXPECT_LT(std::abs(end.moment[2]), 1e-9 * end.normal_force * 1e-3);
}

} // namespace
} // namespace ionskin::mechanics
