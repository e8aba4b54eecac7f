// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/mechanics/engine/motion_stepper.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace ionskin::mechanics {
namespace {

ContactSolution solve(const Case& input, ContactOptions options = {}) {
  base::Timers timers;
  options.threads = 2;
  return solve_contact(input, options, timers);
}

/// Solved once for all tests that only look at it.
const ContactSolution& solved_small_case() {
  static const ContactSolution solution = solve(small_case());
  return solution;
}

const ContactState& at(const ContactSolution& solution, double time) {
  return *nearest(solution, time).state;
}
const ContactState& touchdown(const ContactSolution& solution) {
  return at(solution, 0.5);
}

/// States of the slide after its begin, those of the onset or those behind it.
std::vector<const SteppedInstant*> sliding(const ContactSolution& solution, const Case& input,
                                           bool onset) {
  const double joined = solution.stepped_onsets.empty() ? 0.5 : solution.stepped_onsets.front()[1];
  std::vector<const SteppedInstant*> found;
  for (const SteppedInstant& instant : solution.stepped) {
    if (instant.time > 0.5 && instant.time <= 0.5 + input.motion.slide &&
        (instant.time < joined) == onset) {
      found.push_back(&instant);
    }
  }
  return found;
}

void expect_same_bits(const ContactSolution& one, const ContactSolution& other) {
  ASSERT_EQ(one.stepped.size(), other.stepped.size());
  for (std::size_t i = 0; i < one.stepped.size(); ++i) {
    const SteppedInstant &first = one.stepped[i], &second = other.stepped[i];
    ASSERT_EQ(first.time, second.time);
    ASSERT_EQ(!first.state, !second.state);
    if (first.state) {
      EXPECT_EQ(first.state->normal_traction, second.state->normal_traction);
      EXPECT_EQ(core_strain(*first.state).component, core_strain(*second.state).component);
    }
  }
}

double total_friction(const ContactState& state) {
  return std::hypot(state.tangential_force[0], state.tangential_force[1]);
}

TEST(SolveContact, PathGoesFromTouchdownThroughFullSlipToNothing) {
  const ContactSolution& solution = solved_small_case();
  const Case input = small_case();
  EXPECT_GT(touchdown(solution).normal_force, 1.0);
  EXPECT_GT(sliding(solution, input, true).size(), 8u);
  const auto steady = sliding(solution, input, false);
  EXPECT_GT(steady.size(), 10u);
  for (const SteppedInstant* instant : steady) {
    const ContactState& state = *instant->state;
    const double left = instant->time < 1 ? 1e-2 : 1e-8; // the first ones still come near
    EXPECT_NEAR(total_friction(state), 0.3 * state.normal_force, left * state.normal_force);
    EXPECT_EQ(state.stick_fraction, 0.0);
  }
  EXPECT_EQ(solution.stepped_events.size(), 4u); // lands, slides, lifts, leaves
  EXPECT_NEAR(solution.stepped_events.back(), 2.5 + 0.5 / 1001, 1e-12);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
  EXPECT_LT(solution.worst_complementarity_residual, 1e-8);
  for (const SteppedInstant& instant : solution.stepped) {
    if (instant.state) {
      core_strain(*instant.state);
    }
  }
  EXPECT_LT(at(solution, 0.5).source->worst_equilibrium_residual(), 2e-3);
}

TEST(SolveContact, PlanesOfSymmetryCarryTheirPartOfASlideAcross) {
  Case input = small_case();
  input.skin.sides = SideCondition::symmetry;
  input.motion.direction = {0, 1};
  input.motion.stroke = 2e-5;
  const ContactSolution solution = solve(input);
  for (const SteppedInstant& instant : solution.stepped) {
    if (instant.state) {
      core_strain(*instant.state);
    }
  }
  EXPECT_GT(std::abs(at(solution, 0.7).tangential_force[1]), 0.1);
  EXPECT_LT(touchdown(solution).source->worst_equilibrium_residual(), 2e-3);
}

TEST(SolveContact, ASlideOfTenTimesTheStepsIsTheSame) {
  const Case input = small_case();
  ContactOptions options;
  options.steps = {200, 200, 300, 1.01, 4};
  const ContactSolution fine = solve(input, options);
  const ContactSolution& usual = solved_small_case();
  for (const double time : {0.5, 1.5, 2.5}) {
    EXPECT_NEAR(at(fine, time).normal_force, at(usual, time).normal_force,
                1e-5 * at(usual, time).normal_force);
    EXPECT_NEAR(at(fine, time).tangential_force[0], at(usual, time).tangential_force[0],
                1e-5 * at(usual, time).normal_force);
  }
}

TEST(SolveContact, TouchdownInOneIncrementIsExact) {
  const Case input = small_case();
  const SkinModel model(input, mesh::largest_footprint(input),
                        {{1.5e-3, 1e-3}, {3.5e-3, 1e-3}}); // the whole path
  ContactProblem problem{{}, model.cells.area, model.gap, laws::friction("coulomb", 0.3, {})};
  ContactCompliance(model).at(input.slider.start, problem.compliance);
  const ContactSolution& solution = solved_small_case();
  EXPECT_EQ(std::ranges::count_if(
                solution.stepped,
                [](const SteppedInstant& instant) { return instant.state && instant.time <= 0.5; }),
            1);
  SurfaceState stepped{
      CellVector(3 * model.cells.count()), CellVector(3 * model.cells.count()), {}, {}};
  for (int i = 1; i <= 4; ++i) {
    const SliderStep step{
        {LoadKind::indentation, input.motion.preload * i / 4}, {0, 0}, 0.1, stepped.surface};
    stepped = solve_contact_step(problem, step, stepped.force);
  }
  double sum = 0;
  for (std::size_t i = 0; i < stepped.force.size(); i += 3) {
    sum += stepped.force[i];
  }
  for (std::size_t i = 0; i < model.cells.count(); ++i) {
    EXPECT_NEAR(touchdown(solution).normal_traction[i] * model.cells.area[i], stepped.force[3 * i],
                1e-7 * sum);
    EXPECT_NEAR(touchdown(solution).tangential_traction_x[i] * model.cells.area[i],
                stepped.force[3 * i + 1], 1e-7 * sum);
  }
}

/// The cycle of a case twice in one path.
Case twice(Case input) {
  const std::vector<MotionLeg> legs = motion_legs(input.motion, input.slider);
  const double cycle = legs.back().end();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, legs.front().from, legs.front().from_level.value, {}}};
  const std::vector<double> fields = input.output.fields;
  for (const double begin : {0.0, cycle}) {
    for (const MotionLeg& leg : legs) {
      input.motion.waypoints.push_back({begin + leg.end(), leg.to, leg.to_level.value, {}});
    }
  }
  for (const double instant : fields) {
    input.output.fields.push_back(instant + cycle);
  }
  return input;
}

TEST(SolveContact, ASecondTouchRepeatsTheFirst) {
  for (const char* law : {"coulomb", "regularised"}) {
    Case input = small_case();
    input.contact.law = law;
    if (input.contact.law == "regularised") {
      input.contact.parameters = {{"slip_length", 1e-7}};
    }
    const double cycle = motion_legs(input.motion, input.slider).back().end();
    input.output.fields = {0.5, 0.502, 0.51, 0.55, 1.5, 2.5, 2.5002};
    const std::vector<double> instants = input.output.fields;
    const ContactSolution both = solve(twice(input));
    for (const double instant : instants) {
      const SteppedInstant &first = nearest(both, instant),
                           &second = nearest(both, instant + cycle);
      ASSERT_NEAR(first.time, instant, 1e-12);
      ASSERT_NEAR(second.time, instant + cycle, 1e-12);
      ASSERT_TRUE(first.state && second.state) << instant;
      EXPECT_GT(first.state->normal_force, 0);
      for (std::size_t c = 0; c < first.state->normal_traction.size(); ++c) {
        const double scale = 1e-8 * first.state->normal_force / (1e-3 * 1e-3);
        EXPECT_NEAR(first.state->normal_traction[c], second.state->normal_traction[c], scale);
        EXPECT_NEAR(first.state->tangential_traction_x[c], second.state->tangential_traction_x[c],
                    scale)
            << law << instant;
      }
    }
  }
}

TEST(SolveContact, WithoutFrictionNothingDrags) {
  Case input = small_case();
  input.contact.friction = 0;
  const ContactSolution solution = solve(input);
  EXPECT_TRUE(solution.stepped_onsets.empty());
  // The end of the slide mirrors its begin.
  EXPECT_NEAR(at(solution, 2.5).normal_force, touchdown(solution).normal_force,
              1e-8 * touchdown(solution).normal_force);
  EXPECT_EQ(total_friction(at(solution, 1.5)), 0.0);
}

TEST(SolveContact, PressAndHoldLiftsOffWhereItTouchedDown) {
  Case input = small_case();
  input.motion.stroke = 0;
  const ContactSolution solution = solve(input);
  EXPECT_TRUE(solution.stepped_onsets.empty());
  EXPECT_EQ(at(solution, 2.5).normal_force, touchdown(solution).normal_force);
  // Unloading nearly retraces the loading; only a rim of reversed slip differs.
  const SteppedInstant& half = nearest(solution, 2.5 + 0.25 / 1001);
  EXPECT_NEAR(half.state->normal_force, -half.height / 1e-6 * touchdown(solution).normal_force,
              5e-3 * touchdown(solution).normal_force);
}

TEST(SolveContact, AShortStrokeEndsBeforeFullSliding) {
  Case input = small_case();
  input.motion.stroke = 2e-7;
  const ContactSolution solution = solve(input);
  EXPECT_TRUE(solution.warnings.empty());
  ASSERT_EQ(solution.stepped_onsets.size(), 1u);
  EXPECT_DOUBLE_EQ(solution.stepped_onsets.front()[1], 2.5);
  EXPECT_GT(at(solution, 2.5).stick_fraction, 0.0);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
}

TEST(SolveContact, ObliqueTracksUseTheFullModel) {
  Case input = small_case();
  input.motion.direction = {0.8, 0.6};
  input.motion.stroke = 0.5e-3;
  input.slider.start = {2.3e-3, 0.85e-3}; // symmetric about the middle of the skin
  const ContactSolution solution = solve(input);
  EXPECT_FALSE(solution.mesh.half_model());
  const ContactState &first = *sliding(solution, input, false).front()->state,
                     &last = at(solution, 2.5);
  // Cells slip along the way less what the surface itself moves, which changes along the skin.
  EXPECT_NEAR(last.tangential_force[0], 0.8 * 0.3 * last.normal_force, 1e-4 * last.normal_force);
  EXPECT_NEAR(last.tangential_force[1], 0.6 * 0.3 * last.normal_force, 1e-4 * last.normal_force);
  EXPECT_NEAR(total_friction(last), 0.3 * last.normal_force, 1e-7 * last.normal_force);
  EXPECT_GT(std::abs(first.normal_force / last.normal_force - 1),
            1e-6); // leading and trailing differ
}

TEST(SolveContact, HalfAndFullModelAgree) {
  Case input = small_case();
  input.motion.stroke = 0;
  ContactOptions options;
  options.full_model = true;
  const ContactState half = touchdown(solve(input)), full = touchdown(solve(input, options));
  EXPECT_NEAR(half.normal_force, full.normal_force, 1e-9 * full.normal_force);
}

TEST(SolveContact, AStrokeBackStartsFromSlidingForth) {
  Case input = small_case();
  input.motion.kind = MotionKind::reciprocating;
  input.motion.strokes = 3;
  input.motion.dwell = 0.1;
  const ContactSolution solution = solve(input);
  const ContactState &forth = at(solution, 2.5), &rested = at(solution, 2.6);
  EXPECT_EQ(rested.normal_traction, forth.normal_traction);
  ASSERT_EQ(solution.stepped_onsets.size(), 3u);
  const auto back = std::ranges::find_if(
      solution.stepped, [](const SteppedInstant& instant) { return instant.time > 2.6; });
  // It sticks at first and ends in sliding the other way.
  EXPECT_GT(back->state->stick_fraction, 0.9);
  const ContactState& end = at(solution, 4.6);
  EXPECT_NEAR(end.tangential_force[0], -0.3 * end.normal_force, 1e-8 * end.normal_force);
  // The skin is symmetric about its middle, and the third stroke repeats the first.
  EXPECT_NEAR(end.normal_force, forth.normal_force, 1e-7 * forth.normal_force);
  EXPECT_NEAR(at(solution, 6.7).normal_force, forth.normal_force, 1e-7 * forth.normal_force);
}

TEST(SolveContact, AFrictionCoefficientIsSolvedTheSameBesideOthers) {
  const Case input = small_case();
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const std::vector<ContactSolution> together =
      solve_contact(input, std::vector<double>{0.0, 0.3, 0.6}, options, timers);
  expect_same_bits(together[1], solved_small_case());
}

TEST(SolveContact, ARoundSliderIsSolvedTheSameBesideLargerFrictions) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.motion.preload = 0;
  input.motion.preload_force = 0.2;
  input.contact.friction = 0.1;
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  const auto together = solve_contact(input, std::vector<double>{0.8, 0.1, 0.4}, options, timers);
  expect_same_bits(together[1], solve(input));
}

TEST(SolveContact, AForceIsHeldWithTheIndentationFree) {
  Case input = small_case();
  input.motion.preload = 0;
  input.motion.preload_force = 1;
  const ContactSolution solution = solve(input);
  for (const bool onset : {true, false}) {
    for (const SteppedInstant* instant : sliding(solution, input, onset)) {
      EXPECT_NEAR(instant->state->normal_force, 1, 1e-9);
      EXPECT_NEAR(instant->height, -instant->state->indentation, 1e-15);
    }
  }
  EXPECT_GT(touchdown(solution).indentation, 1e-9);
  // Held at the indentation that the slide ends with, the slider presses with the same force; the
  // lift-off starts from there.
  Case held = input;
  held.motion.preload_force = 0;
  held.motion.preload = at(solution, 2.5).indentation;
  base::Timers timers;
  EXPECT_NEAR(solve_steady_sliding(held, {held.motion.stroke}, {}, timers).front().normal_force, 1,
              1e-7);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
}

TEST(SolveContact, APathMayLandAndLeaveOnTheWay) {
  Case input = small_case();
  input.motion.kind = MotionKind::waypoints;
  input.motion.waypoints = {{0, {1.5e-3, 1e-3}, 1e-6, {}},
                            {1, {2.0e-3, 1e-3}, -1e-6, {}},
                            {2, {3.0e-3, 1e-3}, -1e-6, {}},
                            {3, {3.5e-3, 1e-3}, 1e-6, {}}};
  const ContactSolution solution = solve(input);
  EXPECT_EQ(nearest(solution, 0.5).time, 0.5);
  EXPECT_EQ(nearest(solution, 0.5).state, nullptr);
  EXPECT_EQ(nearest(solution, 1.0).time, 1.0);
  // Slides from the first, and on in the same direction.
  const ContactState& landed = at(solution, 1.0);
  EXPECT_EQ(landed.stick_fraction, 0);
  EXPECT_NEAR(landed.tangential_force[0], 0.3 * landed.normal_force, 1e-8 * landed.normal_force);
  EXPECT_EQ(nearest(solution, 2.5).time, 2.5);
  EXPECT_EQ(nearest(solution, 2.5).state, nullptr);
  EXPECT_EQ(solution.stepped.back().state, nullptr);
  EXPECT_EQ(solution.stepped_events.front(), 0.5);
  EXPECT_EQ(solution.stepped_events.back(), 2.5);
}

TEST(SolveContact, PlaneStrainWithSymmetricSides) {
  Case input = small_case();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 3e-3;
  const ContactSolution solution = solve(input);
  const ContactState& state = at(solution, 1.5);
  EXPECT_NEAR(state.tangential_force[0], 0.3 * state.normal_force, 1e-8 * state.normal_force);
  for (const int c : {1, 3, 5}) { // yy, yz, xy
    for (const double value : core_strain(state).component[c]) {
      ASSERT_NEAR(value, 0, 1e-12);
    }
  }
  EXPECT_LT(solution.worst_complementarity_residual, 1e-8);
}

TEST(SolveContact, AContactAtTheBorderWidensItsOwnMeshOnly) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters["radius"] = 8e-3;
  input.motion.preload = 0;
  input.motion.preload_force = 0.2;
  ContactOptions options;
  options.threads = 2;
  // The contact reaches its border under the larger friction, which drags it along, only.
  constexpr double tight = 1.18e-4;
  options.footprint = mesh::Footprint{{tight, tight}, {tight, tight}};
  base::Timers timers;
  const auto together = solve_contact(input, {0.02, 0.6, 0.7}, options, timers);
  EXPECT_DOUBLE_EQ(together[0].cell_lines_x.back(), tight);
  EXPECT_GT(together[1].cell_lines_x.back(), 1.2 * tight);
  EXPECT_EQ(together[1].cell_lines_x, together[2].cell_lines_x);
  for (const std::size_t i : {0, 1}) {
    const auto alone = solve_contact(input, {std::array{0.02, 0.6}[i]}, options, timers);
    const ContactState &expected = touchdown(alone[0]), &found = touchdown(together[i]);
    EXPECT_EQ(found.normal_traction, expected.normal_traction);
    EXPECT_EQ(core_strain(found).component, core_strain(expected).component);
  }
}

TEST(SolveContact, AFlatHeightMapIsAFlatSlider) {
  Case input = small_case();
  input.motion.stroke = 0;
  const double force = touchdown(solve(input)).normal_force;
  input.slider.shape = "profile";
  input.slider.profile_heights = {{-0.5e-3, 0.5e-3}, {-0.4e-3, 0.4e-3}, {0, 0, 0, 0}};
  const ContactSolution map = solve(input);
  EXPECT_NEAR(touchdown(map).normal_force, force, 5e-3 * force);
  EXPECT_TRUE(map.warnings.empty());
  input.slider.pose.yaw = 0.3;
  const ContactSolution turned = solve(input);
  ASSERT_EQ(turned.warnings.size(), 1u);
  EXPECT_NE(turned.warnings.front().find("slider.yaw"), std::string::npos);
}

TEST(SolveContact, WarnsOfAHeightMapFinerThanItsCells) {
  Case input = small_case();
  input.slider.shape = "profile";
  input.motion.stroke = 0;
  for (int i = -50; i <= 50; ++i) {
    input.slider.profile_heights.x.push_back(1e-5 * i);
    input.slider.profile_heights.y.push_back(1e-5 * i);
  }
  const auto warns = [&](double ripple) {
    input.slider.profile_heights.height.clear();
    for (int j = -50; j <= 50; ++j) {
      for (int i = -50; i <= 50; ++i) {
        input.slider.profile_heights.height.push_back((i % 2 == 0 ? ripple : 0) +
                                                      2e-11 * (i * i + j * j));
      }
    }
    return std::ranges::any_of(solve(input).warnings, [](const std::string& warning) {
      return warning.find("height map has features finer") != std::string::npos;
    });
  };
  EXPECT_TRUE(warns(0.5e-6));
  EXPECT_FALSE(warns(0));
}

} // namespace
} // namespace ionskin::mechanics
