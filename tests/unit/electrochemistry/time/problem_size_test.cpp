// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/problem_size.hpp"

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

TEST(ProblemSize, IsThatOfTheRunAndItsStepsAreNear) {
  Case input = verification::model_case();
  input.numerics.preset = Preset::coarse;
  const auto history = verification::linear_step_history(0.0, 0.01, {0.0, 0.5});
  const ProblemSize size = problem_size(input, history);
  base::Timers timers;
  const IonSolution solution = solve_ion_transport(input, history, {}, timers);
  EXPECT_NEAR(static_cast<double>(size.steps), static_cast<double>(solution.steps),
              0.5 * static_cast<double>(solution.steps));
  EXPECT_EQ(size.levels, solution.grid.z_nodes.size());
  EXPECT_EQ(size.unknowns, 2 * solution.grid.z_nodes.size());
}

TEST(ProblemSize, EstimateFromTheMotionIsNearTheRealOne) {
  const Case input = verification::model_case();
  const ProblemSize estimate = estimate_problem_size(input);
  const ProblemSize exact = problem_size(input, verification::sliding_contact_history(3));
  EXPECT_EQ(estimate.unknowns, exact.unknowns);
  constexpr double steps_of_the_paper_case = 443, steps_of_its_coarse_preset = 349;
  EXPECT_NEAR(static_cast<double>(estimate.steps), steps_of_the_paper_case,
              0.2 * steps_of_the_paper_case);
  Case coarse = input;
  coarse.numerics.preset = Preset::coarse;
  EXPECT_NEAR(static_cast<double>(estimate_problem_size(coarse).steps), steps_of_its_coarse_preset,
              0.2 * steps_of_its_coarse_preset);
  EXPECT_GT(estimate.memory, 8.0 * static_cast<double>(estimate.unknowns));
}

TEST(ProblemSize, PlaneStrainNeedsOneColumnInY) {
  Case input = verification::model_case();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 3e-3;
  EXPECT_EQ(estimate_problem_size(input).columns_y, 1U);
}

} // namespace
} // namespace ionskin::electrochemistry
