// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/engine/compliant_drive.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::mechanics {
namespace {

/// Nothing holds the slider: the drive's own differential equation.
std::vector<double> free_swing(const Drive& drive, double time, int steps) {
  CompliantDrive slider(drive, 1, {true, true});
  slider.hold({});
  const DriveEnd end{{1e-3, -2e-3}, {}}; // it jumps aside
  for (int i = 0; i < steps; ++i) {
    const SliderGuide guide = slider.guide(time / steps, end);
    slider.accept(time / steps, guide.place, end);
  }
  return {slider.place()[0], slider.place()[1]};
}

TEST(CompliantDrive, SwingsWithSecondOrder) {
  const Drive drive{200, 0.4, 5e-3};
  const double decay = drive.damping / (2 * drive.mass);
  const double frequency = std::sqrt(drive.stiffness / drive.mass - decay * decay);
  const double time = 0.02;
  const double left = std::exp(-decay * time) *
                      (std::cos(frequency * time) + decay / frequency * std::sin(frequency * time));
  std::vector<double> error;
  for (const int steps : {100, 200, 400}) {
    const auto place = free_swing(drive, time, steps);
    error.push_back(std::abs(place[0] - 1e-3 * (1 - left)));
    EXPECT_NEAR(place[1], -2 * place[0], 1e-15);
  }
  EXPECT_LT(error[2], 1e-6);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
  EXPECT_GT(std::log2(error[1] / error[2]), 1.7);
}

TEST(CompliantDrive, WithoutMassItCreepsAndWithoutDampingItIsASpring) {
  const auto place = free_swing({100, 2, 0}, 0.02, 400);
  EXPECT_NEAR(place[0], 1e-3 * (1 - std::exp(-1)), 1e-7);
  CompliantDrive spring({100, 0, 0}, 0.5, {true, false});
  spring.hold({});
  const SliderGuide guide = spring.guide(1e-3, {{1e-3, 2e-3}, {}});
  EXPECT_DOUBLE_EQ(guide.place[0], 1e-3);
  EXPECT_DOUBLE_EQ(guide.compliance[0], 1 / (0.5 * 100)); // of half of the skin
  EXPECT_EQ(guide.place[1], 2e-3);
  EXPECT_EQ(guide.compliance[1], 0);
}

Case driven_case() {
  Case input = small_case();
  input.motion.preload = 0;
  input.motion.preload_force = 1;
  input.motion.drive = {2000, 1, 5e-3};
  return input;
}

ContactSolution solved(const Case& input) {
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  return solve_contact(input, options, timers);
}

TEST(DrivenSlider, LagsByFrictionOverStiffnessAndLandsAtTheDrive) {
  Case input = driven_case();
  const ContactSolution solution = solved(input);
  const SteppedInstant& sliding = nearest(solution, 1.5); // the middle of the slide
  const double friction = sliding.state->tangential_force[0];
  EXPECT_NEAR(friction, 0.3, 1e-4);
  EXPECT_NEAR(sliding.drive_force[0], friction, 1e-4);
  // 1 mm/s through the damper is 0 while both go alike.
  EXPECT_NEAR(sliding.centre[0], 2.5e-3 - friction / 2000, 1e-7);
  EXPECT_LT(solution.worst_complementarity_residual, 1e-6);
  EXPECT_EQ(solution.stepped.front().centre[0], 1.5e-3);
  EXPECT_EQ(solution.stepped.back().centre[0], 1.5e-3);
  EXPECT_EQ(solution.stepped.back().drive_force[0], 0);
}

TEST(DrivenSlider, OfAStiffDriveIsTheSliderWithoutOne) {
  Case input = driven_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-3, {}},
                            {0.5, {1.5e-3, 1e-3}, {}, 1.0},
                            {1.5, {2.5e-3, 1e-3}, {}, 1.0},
                            {2, {2.5e-3, 1e-3}, 1e-3, {}}};
  input.motion.drive.stiffness = 1e9;
  input.motion.drive.mass = 0;
  const ContactSolution driven = solved(input);
  input.motion.drive = {};
  const ContactSolution led = solved(input);
  for (const double time : {0.5, 1.0, 1.5}) {
    const SteppedInstant &a = nearest(driven, time), &b = nearest(led, time);
    ASSERT_TRUE(a.state && b.state) << time;
    EXPECT_NEAR(a.time, b.time, 1e-12);
    EXPECT_NEAR(a.state->tangential_force[0], b.state->tangential_force[0], 2e-4) << time;
    EXPECT_NEAR(a.centre[0], b.centre[0], 1e-9) << time;
  }
}

TEST(DrivenSlider, SwingsOnWhereThePathHaltsBeyondItsEnd) {
  Case input = driven_case();
  input.contact.friction = 0.002;
  input.motion.drive = {100, 0, 50e-3}; // a period of 140 ms
  input.motion.stroke = 1e-3;
  input.motion.slide = 0.01; // 0.1 m/s
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 2;
  input.motion.dwell = 0.2;
  input.motion.preload_force = 5;
  const ContactSolution solution = solved(input);
  double furthest = 0;
  for (const SteppedInstant& instant : solution.stepped) {
    furthest = std::max(furthest, instant.centre[0]);
  }
  EXPECT_GT(furthest, 2.6e-3);
  EXPECT_LT(solution.worst_complementarity_residual, 1e-6);
}

bool warns_of_an_edge(const ContactSolution& solution) {
  return std::ranges::any_of(solution.warnings, [](const std::string& warning) {
    return warning.find("nearer to an edge") != std::string::npos;
  });
}

TEST(DrivenSlider, SaysWhereItComesNearerToAnEdgeThanExpected) {
  Case input = driven_case();
  input.contact.friction = 0.002;
  input.motion.drive = {100, 0, 50e-3}; // a period of 140 ms: it swings on by 1 mm
  input.motion.stroke = 1.6e-3;
  input.motion.slide = 0.02;
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 2;
  input.motion.dwell = 0.2;
  input.motion.preload_force = 5;
  double furthest = 0;
  const ContactSolution solution = solved(input);
  for (const SteppedInstant& instant : solution.stepped) {
    furthest = std::max(furthest, instant.centre[0]);
  }
  EXPECT_TRUE(warns_of_an_edge(solution)) << furthest;
  EXPECT_FALSE(warns_of_an_edge(solved(driven_case())));
}

TEST(DrivenSlider, OffTheMiddleItsStrainIsThatOfThePlaceWhereItIs) {
  Case input = driven_case();
  input.slider.start[1] -= 0.1e-3;
  const ContactSolution solution = solved(input);
  double aside = 0;
  for (const SteppedInstant& instant : solution.stepped) {
    if (instant.state) {
      aside = std::max(aside, std::abs(instant.centre[1] - input.slider.start[1]));
      EXPECT_FALSE(core_strain(*instant.state).component[4].empty());
    }
  }
  EXPECT_GT(aside, 1e-8); // it yields along y, too
}

TEST(DrivenSlider, IsGivenUpWhereItsStepsGetNowhere) {
  const Case input = driven_case();
  base::Timers timers;
  ContactOptions options;
  options.steps.most_driven = 10; // far fewer than the motion takes
  try {
    solve_contact(input, options, timers);
    FAIL() << "no end";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("10 contacts were solved"), std::string::npos)
        << error.what();
    EXPECT_NE(error.remedy().find("motion.drive.mass"), std::string::npos) << error.remedy();
  }
}

} // namespace
} // namespace ionskin::mechanics
