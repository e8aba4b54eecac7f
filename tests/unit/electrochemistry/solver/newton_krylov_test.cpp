// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

class Newton : public testing::Test {
protected:
  Newton() : start(grid.nodes(), 1.0), fixed(grid.nodes()), state(grid.nodes()) {
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      fixed[i] = 1.0 + 0.5 * std::sin(0.9 * static_cast<double>(i));
    }
    std::ranges::fill(state.concentration(), 1.0);
    amount = ExactAverage::total(grid, start);
  }

  double largest_residual(const StageProblem& problem) {
    std::vector<double> residual(2 * grid.nodes());
    TransportEquations(grid, team).residual(problem, state, residual);
    double largest = 0.0;
    for (const double value : residual) {
      largest = std::max(largest, std::abs(value));
    }
    return largest;
  }

  ScaledGrid grid = test::small_grid();
  std::vector<double> start, fixed;
  IonState state;
  double amount = 0;
  parallel::WorkerTeam team{1};
};

TEST_F(Newton, SolvesAStageWithStrongFieldsAndKeepsIonsAndCharge) {
  const StageProblem problem{start, 2.0, fixed, -1.5, 1.5, amount};
  NewtonKrylov newton(grid, 3e-5, team);
  newton.prepare(state, problem.step);
  ASSERT_TRUE(newton.solve(problem, state));
  EXPECT_LT(largest_residual(problem), 1e-4);
  EXPECT_GT(*std::ranges::min_element(state.concentration()), 0.0);
  EXPECT_NEAR(ExactAverage::total(grid, state.concentration()), amount, 1e-13 * amount);

  WallCharges charges;
  wall_charges(grid, state, fixed, charges);
  const double fixed_total = ExactAverage::total(grid, fixed) - amount;
  EXPECT_NEAR(charges.total_bottom + charges.total_top, fixed_total, 1e-11);
  EXPECT_NEAR(charges.total_top, ramo_charge_top(grid, state, fixed), 1e-11);
}

TEST_F(Newton, ClosesTheCircuitExactlyWithoutMoreIterations) {
  NewtonKrylov given(grid, 3e-5, team);
  IonState shorted = state;
  given.prepare(shorted, 2.0);
  ASSERT_TRUE(given.solve({start, 2.0, fixed, 0.0, 0.0, amount}, shorted));
  // Open, the core's own impedance, and nearly shorted.
  for (const double conductance : {0.0, 0.3, 1e6}) {
    const CircuitStage circuit{0.25, conductance};
    const StageProblem problem{start, 2.0, fixed, 0.4, 0.0, amount, circuit};
    NewtonKrylov newton(grid, 3e-5, team);
    IonState closed = state;
    newton.prepare(closed, problem.step);
    ASSERT_TRUE(newton.solve(problem, closed));
    EXPECT_LE(newton.counters().krylov_iterations, given.counters().krylov_iterations + 4);
    WallCharges charges;
    wall_charges(grid, closed, fixed, charges);
    const double voltage = closed.potential().back() - closed.potential().front();
    const double charge =
        0.5 * (charges.total_top - charges.total_bottom) / static_cast<double>(grid.columns());
    EXPECT_NEAR(charge, circuit.start - conductance * voltage, 1e-12 + 1e-16 * conductance);
    EXPECT_EQ(closed.potential().front(), 0.4);
    EXPECT_NEAR(ExactAverage::total(grid, closed.concentration()), amount, 1e-13 * amount);
  }
}

TEST_F(Newton, RestStaysAtRestExactly) {
  NewtonKrylov newton(grid, 3e-5, team);
  newton.prepare(state, 3.0);
  ASSERT_TRUE(newton.solve({start, 3.0, start, 0.0, 0.0, amount}, state));
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    EXPECT_EQ(state.concentration()[i], 1.0);
    EXPECT_EQ(state.potential()[i], 0.0);
  }
}

TEST_F(Newton, GivesUpOnNonsense) {
  fixed[grid.columns() + 3] = std::nan("");
  NewtonKrylov newton(grid, 3e-5, team);
  newton.prepare(state, 1.0);
  EXPECT_FALSE(newton.solve({start, 1.0, fixed, 0.0, 0.0, amount}, state));
}

} // namespace
} // namespace ionskin::electrochemistry
