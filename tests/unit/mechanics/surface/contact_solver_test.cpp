// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace ionskin::mechanics {
namespace {

/// Cells along a line, coupled like points on an elastic surface: decaying with distance, normal
/// and tangential motion coupled with opposite signs on the two sides.
ContactProblem line_of_cells(int cells, double friction) {
  ContactProblem problem;
  problem.friction = laws::friction("coulomb", friction, {});
  problem.area.assign(static_cast<std::size_t>(cells), 1e-8);
  problem.gap.assign(static_cast<std::size_t>(cells), 0.0);
  problem.compliance = Eigen::MatrixXd::Zero(3 * cells, 3 * cells);
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double near = 1e-7 / (0.6 + std::abs(i - j)) + (i == j ? 1e-7 : 0);
      for (int c = 0; c < 3; ++c) {
        problem.compliance(3 * i + c, 3 * j + c) = (c == 0 ? 1.0 : 1.3) * near;
      }
      const double coupling = i == j ? 0 : 2e-8 / (i - j);
      problem.compliance(3 * i, 3 * j + 1) = coupling;
      problem.compliance(3 * j + 1, 3 * i) = coupling;
    }
  }
  return problem;
}

SliderStep press(const ContactProblem& problem, double indentation,
                 std::array<double, 2> travel = {0, 0}) {
  return {
      {LoadKind::indentation, indentation}, travel, 0.1, CellVector(3 * problem.area.size(), 0.0)};
}

SurfaceState solve(const ContactProblem& problem, const SliderStep& step) {
  return solve_contact_step(problem, step, CellVector(3 * problem.area.size(), 0.0));
}

double worst_violation(const ContactProblem& problem, const SurfaceState& state) {
  double largest = 0;
  for (std::size_t i = 0; i < state.force.size(); i += 3) {
    largest = std::max(largest, state.force[i]);
  }
  return contact_violations(problem, state, largest, state.indentation).largest();
}

TEST(ContactSolver, OneCellByHand) {
  ContactProblem problem = line_of_cells(1, 0.5);
  const double normal_compliance = problem.compliance(0, 0), tangential = problem.compliance(1, 1);
  const double normal = 1e-6 / normal_compliance;
  // Sticks below the limit and slips beyond.
  const double limit_travel = 0.5 * normal * tangential;
  EXPECT_NEAR(solve(problem, press(problem, 1e-6, {0.5 * limit_travel, 0})).force[1], 0.25 * normal,
              1e-9 * normal);
  const SurfaceState slipping = solve(problem, press(problem, 1e-6, {3 * limit_travel, 0}));
  EXPECT_NEAR(slipping.force[1], 0.5 * normal, 1e-9 * normal);
  EXPECT_NEAR(slipping.slip[0], 2 * limit_travel, 1e-9 * limit_travel);
}

TEST(ContactSolver, FullStickIsALinearSolve) {
  const ContactProblem problem = line_of_cells(12, 50.0);
  const SurfaceState state = solve(problem, press(problem, 1e-6, {2e-7, -1e-7}));
  const Eigen::MatrixXd& c = problem.compliance;
  Eigen::VectorXd right(36);
  for (int i = 0; i < 12; ++i) {
    right.segment<3>(3 * i) << 1e-6, 2e-7, -1e-7;
  }
  const Eigen::VectorXd expected = c.llt().solve(right);
  for (int i = 0; i < 36; ++i) {
    EXPECT_NEAR(state.force[static_cast<std::size_t>(i)], expected[i], 1e-9 * expected.norm());
  }
}

TEST(ContactSolver, PartialSlipSatisfiesEveryCondition) {
  for (const double friction : {0.0, 0.05, 0.3, 0.8}) {
    const ContactProblem problem = line_of_cells(30, friction);
    SurfaceState state = solve(problem, press(problem, 1e-6));
    EXPECT_LT(worst_violation(problem, state), 1e-8) << friction;
    for (int i = 0; i < 8; ++i) {
      SliderStep step = press(problem, 1e-6, {6e-8, 2e-8});
      step.surface_before = state.surface;
      state = solve_contact_step(problem, step, state.force);
      EXPECT_LT(worst_violation(problem, state), 1e-8) << friction << " step " << i;
    }
  }
}

TEST(ContactSolver, NoIndentationMeansNoForce) {
  const ContactProblem problem = line_of_cells(10, 0.3);
  const SurfaceState loaded = solve(problem, press(problem, 1e-6, {5e-7, 0}));
  SliderStep lifted = press(problem, 0);
  lifted.surface_before = loaded.surface;
  const SurfaceState state = solve_contact_step(problem, lifted, loaded.force);
  for (const double force : state.force) {
    EXPECT_NEAR(force, 0, 1e-12);
  }
}

TEST(SteadySliding, IsTheLimitOfALongSlide) {
  const ContactProblem problem = line_of_cells(15, 0.4);
  const SurfaceState steady =
      steady_sliding(problem, {LoadKind::indentation, 1e-6}, {0.6, 0.8}, 1e-3);
  EXPECT_LT(worst_violation(problem, steady), 1e-12);
  SurfaceState state = solve(problem, press(problem, 1e-6));
  for (int i = 0; i < 60; ++i) {
    SliderStep step = press(problem, 1e-6, {0.6e-5, 0.8e-5});
    step.surface_before = state.surface;
    state = solve_contact_step(problem, step, state.force);
  }
  for (std::size_t i = 0; i < state.force.size(); ++i) {
    EXPECT_NEAR(state.force[i], steady.force[i], 1e-6);
  }
}

TEST(SteadySliding, FindsLimitsThatAreNotInProportionToThePressure) {
  constexpr double strength = 3e7; // [Pa]; Coulomb's limit is several times that here
  constexpr double mu = 0.4;
  const laws::Friction saturating{
      "saturating", mu,
      [](const laws::FrictionArguments& at) {
        return strength * std::tanh(mu * std::max(0.0, at.normal_traction) / strength);
      },
      [](const laws::FrictionArguments& at) {
        return mu / std::pow(std::cosh(mu * at.normal_traction / strength), 2);
      }};
  ContactProblem problem = line_of_cells(15, mu);
  problem.friction = saturating;
  for (const SliderLoad& load :
       {SliderLoad{LoadKind::indentation, 1e-6}, SliderLoad{LoadKind::force, 30.0}}) {
    const SurfaceState steady = steady_sliding(problem, load, {0.6, 0.8}, 1e-3);
    EXPECT_LT(worst_violation(problem, steady), 1e-10);
    const double share = std::hypot(steady.force[1], steady.force[2]) / (0.4 * steady.force[0]);
    EXPECT_LT(share, 0.95);
  }
}

TEST(SteadySliding, NamesALawThatGivesNotANumberThere) {
  const laws::Friction viscous{
      "viscous", 0.4,
      [](const laws::FrictionArguments& at) {
        return 0.4 * at.normal_traction * at.slip_increment / at.time_step; // 0 / 0
      },
      [](const laws::FrictionArguments& at) { return 0.4 * at.slip_increment / at.time_step; }};
  ContactProblem problem = line_of_cells(5, 0.4);
  problem.friction = viscous;
  try {
    steady_sliding(problem, {LoadKind::indentation, 1e-6}, {1, 0}, 1e-3);
    FAIL() << "0 / 0 passed for a friction limit";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("\"viscous\""), std::string::npos) << error.what();
  }
}

/// Cells under a round slider whose lowest point is over the middle of the line.
ContactProblem round_slider(int cells, double friction) {
  ContactProblem problem = line_of_cells(cells, friction);
  for (int i = 0; i < cells; ++i) {
    problem.gap[static_cast<std::size_t>(i)] = 1e-8 * std::pow(i - (cells - 1) / 2.0, 2);
  }
  return problem;
}

TEST(ContactSolver, ARoundSliderTouchesOnlyWhereItReaches) {
  const ContactProblem problem = round_slider(30, 0.3);
  SurfaceState state = solve(problem, press(problem, 1e-6));
  EXPECT_GT(state.force[3 * 14], 0.0);
  EXPECT_EQ(state.force[0], 0.0);
  EXPECT_EQ(state.force[3 * 29], 0.0);
  for (int i = 0; i < 8; ++i) {
    SliderStep step = press(problem, 1e-6, {6e-8, 2e-8});
    step.surface_before = state.surface;
    state = solve_contact_step(problem, step, state.force);
    EXPECT_LT(worst_violation(problem, state), 1e-8) << i;
  }
}

TEST(ContactSolver, AGivenForceIsHeldThroughTouchdownSlidingAndRelease) {
  for (const bool round : {false, true}) {
    for (const double friction : {0.0, 0.3, 0.6}) {
      const ContactProblem problem =
          round ? round_slider(30, friction) : line_of_cells(30, friction);
      SurfaceState state{CellVector(90, 0.0), CellVector(90, 0.0), {}, {}};
      const auto advance = [&](double force, std::array<double, 2> travel) {
        const SliderStep step{{LoadKind::force, force}, travel, 0.1, state.surface};
        state = solve_contact_step(problem, step, state.force);
        EXPECT_NEAR(total_normal_force(state.force), force, 1e-10 * force);
        EXPECT_LT(worst_violation(problem, state), 1e-8) << round << ' ' << friction;
      };
      advance(20.0, {0, 0});
      for (int i = 0; i < 6; ++i) {
        advance(20.0, {6e-8, 2e-8});
      }
      advance(5.0, {0, 0});
      advance(0.01, {0, 0});
      const SliderStep release{{LoadKind::force, 0.0}, {0, 0}, 0.1, state.surface};
      state = solve_contact_step(problem, release, state.force);
      EXPECT_EQ(total_normal_force(state.force), 0.0);
      EXPECT_EQ(state.indentation, *std::min_element(problem.gap.begin(), problem.gap.end()));
    }
  }
}

TEST(ContactSolver, ForceAndIndentationControlAgree) {
  const ContactProblem problem = round_slider(25, 0.4);
  const SurfaceState given = solve(problem, press(problem, 8e-7, {1e-7, 0}));
  SliderStep step = given.step;
  step.load = {LoadKind::force, total_normal_force(given.force)};
  const SurfaceState found = solve(problem, step);
  EXPECT_NEAR(found.indentation, 8e-7, 1e-9 * 8e-7);
  for (std::size_t i = 0; i < given.force.size(); ++i) {
    EXPECT_NEAR(found.force[i], given.force[i], 1e-8 * step.load.value);
  }
}

TEST(SteadySliding, CarriesAGivenForceUnderAnySlider) {
  for (const auto& problem : {line_of_cells(25, 0.4), round_slider(25, 0.4)}) {
    const SurfaceState state = steady_sliding(problem, {LoadKind::force, 7.0}, {0.8, -0.6}, 1e-3);
    EXPECT_NEAR(total_normal_force(state.force), 7.0, 7e-10);
    EXPECT_LT(worst_violation(problem, state), 1e-10);
    const SurfaceState same =
        steady_sliding(problem, {LoadKind::indentation, state.indentation}, {0.8, -0.6}, 1e-3);
    EXPECT_NEAR(total_normal_force(same.force), 7.0, 7e-9);
  }
}

/// Sum of the tangential forces over that of the normal ones, after sliding far along a direction.
std::array<double, 2> slid_along(ContactProblem problem, const laws::Friction& law,
                                 std::array<double, 2> direction) {
  problem.friction = law;
  SurfaceState state = solve(problem, press(problem, 1e-6));
  for (int i = 0; i < 40; ++i) {
    SliderStep step = press(problem, 1e-6, {1e-6 * direction[0], 1e-6 * direction[1]});
    step.surface_before = state.surface;
    state = solve_contact_step(problem, step, state.force);
    EXPECT_LT(worst_violation(problem, state), 1e-8) << i;
  }
  std::array<double, 3> sum{};
  for (std::size_t at = 0; at < state.force.size(); ++at) {
    sum[at % 3] += state.force[at];
  }
  return {sum[1] / sum[0], sum[2] / sum[0]};
}

TEST(ContactSolver, AnisotropicFrictionPullsTowardsTheEasyDirection) {
  const auto law = laws::friction("anisotropic", 0.4, {{"transverse_friction", 0.1}});
  const ContactProblem problem = line_of_cells(20, 0.4);
  const auto along = slid_along(problem, law, {1, 0}), across = slid_along(problem, law, {0, 1});
  EXPECT_NEAR(along[0], 0.4, 1e-6);
  EXPECT_NEAR(along[1], 0, 1e-6);
  EXPECT_NEAR(across[0], 0, 1e-6);
  EXPECT_NEAR(across[1], 0.1, 1e-6);
  const auto oblique = slid_along(problem, law, {0.6, 0.8});
  const double length = std::hypot(0.4 * 0.6, 0.1 * 0.8);
  EXPECT_NEAR(oblique[0], 0.16 * 0.6 / length, 1e-5);
  EXPECT_NEAR(oblique[1], 0.01 * 0.8 / length, 1e-5);
}

TEST(ContactDiagnostics, SeeEachViolation) {
  const ContactProblem problem = line_of_cells(5, 0.3);
  const SurfaceState good = solve(problem, press(problem, 1e-6, {1e-6, 0}));
  const auto violations = [&](SurfaceState state) {
    state.surface = problem.surface_displacement(state.force);
    return contact_violations(problem, state, good.force[0], 1e-6);
  };
  SurfaceState bad = good;
  bad.force[6] = -good.force[0];
  EXPECT_NEAR(violations(bad).tension, 1, 1e-12);
  bad = good;
  bad.force[6] *= 1.1;
  EXPECT_GT(violations(bad).penetration, 1e-3);
  bad = good;
  bad.force[7] *= 1.1;
  EXPECT_GT(violations(bad).cone, 1e-3);
  bad = good;
  bad.force[7] *= -1;
  EXPECT_GT(violations(bad).slip_law, 1e-3);
  EXPECT_EQ(stick_fraction(problem, good.force), 0.0);
}

TEST(SteadySliding, TouchesNothingAboveTheLowestCell) {
  ContactProblem problem = line_of_cells(3, 0.5);
  problem.gap = {2e-6, 1e-6, 3e-6};
  const SurfaceState state = steady_sliding(problem, {LoadKind::indentation, 0.5e-6}, {1, 0}, 1e-6);
  EXPECT_EQ(state.force, CellVector(9, 0.0));
  EXPECT_EQ(state.slip, std::vector<double>(3, 1e-6));
  EXPECT_EQ(contact_violations(problem, state, 0, state.indentation).largest(), 0);
}

TEST(SteadySliding, VanishingForceIsTheFirstTouch) {
  ContactProblem problem = line_of_cells(3, 0.5);
  problem.gap = {2e-6, 1e-6, 3e-6};
  const SurfaceState none = steady_sliding(problem, {LoadKind::force, 0}, {1, 0}, 0);
  EXPECT_EQ(none.indentation, 1e-6);
  EXPECT_EQ(none.force, CellVector(9, 0.0));
  const SurfaceState little = steady_sliding(problem, {LoadKind::force, 1e-9}, {1, 0}, 0);
  EXPECT_NEAR(little.force[3], 1e-9, 1e-14);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ContactSolver, NaNIsNoConvergence) {
  ContactProblem problem = line_of_cells(3, 0.5);
  problem.compliance(3, 3) = nan;
  const SliderStep step = press(problem, 1e-6);
  Iterate iterate{CellVector(9, 0.0), 1e-6};
  EXPECT_FALSE(ContactNewton().solve(problem, step, iterate));
  EXPECT_THROW(solve(problem, step), SolverError);
  EXPECT_THROW(steady_sliding(problem, {LoadKind::indentation, 1e-6}, {1, 0}, 0), SolverError);
}

TEST(ContactSolver, NamesALawThatGivesNotANumberInSteadySliding) {
  ContactProblem problem = line_of_cells(3, 0.5);
  problem.friction.law = "of slip over time step";
  problem.friction.limit = [](const laws::FrictionArguments& at) {
    return 0.5 * at.normal_traction * (1 + at.slip_increment / at.time_step);
  };
  try {
    steady_sliding(problem, {LoadKind::indentation, 1e-6}, {1, 0}, 0);
    FAIL() << "0 / 0 passed for a limit";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("\"of slip over time step\""), std::string::npos)
        << error.what();
  }
}

TEST(ContactDiagnostics, NaNIsAViolation) {
  const ContactProblem problem = line_of_cells(3, 0.5);
  SurfaceState state = solve(problem, press(problem, 1e-6));
  state.force[3] = nan;
  EXPECT_TRUE(std::isnan(contact_violations(problem, state, 1, 1e-6).largest()));
}

} // namespace
} // namespace ionskin::mechanics
