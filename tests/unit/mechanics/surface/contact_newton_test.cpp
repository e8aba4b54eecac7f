// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ionskin::mechanics {
namespace {

constexpr int cells_across = 15;

/// Square cells of 0.1 mm under a sphere of 8 mm, on something like an elastic half-space: each
/// cell gives little by itself beside what its neighbours press it down.
ContactProblem sphere_on_many_cells(double friction) {
  constexpr int cells = cells_across * cells_across;
  constexpr double width = 1e-4, radius = 8e-3, softness = 1e-10; // displacement [m2/N] by 1/r
  ContactProblem problem;
  problem.friction = laws::friction("coulomb", friction, {});
  problem.area.assign(cells, width * width);
  problem.compliance = Eigen::MatrixXd::Zero(3 * cells, 3 * cells);
  const auto place = [&](int cell) -> std::array<double, 2> {
    return {width * (cell % cells_across - cells_across / 2),
            width * (cell / cells_across - cells_across / 2)};
  };
  for (int i = 0; i < cells; ++i) {
    const auto at = place(i);
    problem.gap.push_back((at[0] * at[0] + at[1] * at[1]) / (2 * radius));
    for (int j = 0; j < cells; ++j) {
      const auto from = place(j);
      const double r = std::hypot(at[0] - from[0], at[1] - from[1]);
      for (int c = 0; c < 3; ++c) {
        problem.compliance(3 * i + c, 3 * j + c) = softness / std::max(r, 0.28 * width);
      }
    }
  }
  return problem;
}

TEST(ContactNewton, FindsTheContactWhereASliderIsLiftedByMoreThanCellsGiveAlone) {
  for (const double friction : {0.0, 0.3}) {
    const ContactProblem problem = sphere_on_many_cells(friction);
    const CellVector none(3 * problem.area.size(), 0.0);
    constexpr double deepest = 2e-5;
    const SurfaceState pressed =
        solve_contact_step(problem, {{LoadKind::indentation, deepest}, {0, 0}, 0.1, none}, none);
    for (const double share : {0.95, 0.6, 0.2}) {
      SCOPED_TRACE(share);
      const SliderStep step{
          {LoadKind::indentation, share * deepest}, {1e-6, 0}, 0.1, pressed.surface};
      ContactNewton newton;
      Iterate iterate{pressed.force, pressed.indentation};
      ASSERT_TRUE(newton.solve(problem, step, iterate));
      const SurfaceState direct = solve_contact_step(problem, step, none);
      const double expected = total_normal_force(direct.force);
      EXPECT_NEAR(total_normal_force(iterate.force), expected, 1e-8 * expected);
      const SurfaceState found =
          surface_state(problem, step, iterate.force, iterate.indentation, newton.iterations());
      EXPECT_LT(contact_violations(problem, found, expected, deepest).largest(), 1e-8);
    }
  }
}

/// Steps of any size, each from no forces and from those before.
TEST(ContactNewton, TakesAnyStepUnderAnyFriction) {
  constexpr double deepest = 2e-5, heaviest = 20;
  for (const double friction : {0.3, 2.0}) {
    const ContactProblem problem = sphere_on_many_cells(friction);
    const CellVector none(3 * problem.area.size(), 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const bool by_force : {false, true}) {
      SurfaceState state{.force = none, .surface = none};
      for (int i = 0; i < 12; ++i) {
        const double level = std::abs(unit(random)), way = std::pow(10, -4 - 3 * level);
        const SliderStep step{by_force ? SliderLoad{LoadKind::force, level * heaviest}
                                       : SliderLoad{LoadKind::indentation, level * deepest},
                              {way * unit(random), way * unit(random)},
                              0.1,
                              state.surface};
        SCOPED_TRACE(i);
        Iterate near{state.force, state.indentation}, anew{none, 0};
        ContactNewton newton;
        ASSERT_TRUE(newton.solve(problem, step, near));
        ASSERT_TRUE(ContactNewton().solve(problem, step, anew));
        const double load = total_normal_force(near.force);
        EXPECT_NEAR(total_normal_force(anew.force), load, 1e-8 * load);
        state = surface_state(problem, step, near.force, near.indentation, newton.iterations());
        EXPECT_LT(contact_violations(problem, state, load, deepest).largest(), 1e-8);
      }
    }
  }
}

} // namespace
} // namespace ionskin::mechanics
