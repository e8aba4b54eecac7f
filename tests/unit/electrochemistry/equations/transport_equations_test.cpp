// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/transport_equations.hpp"

#include "ionskin/electrochemistry/solver/closed_preconditioner.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

class Equations : public testing::Test {
protected:
  Equations()
      : start(grid.nodes(), 1.0), fixed(grid.nodes(), 1.1),
        residual(2 * grid.nodes()), problem{start, 0.8, fixed, 0.3, -0.2} {}

  void expect_exact_jacobian(std::optional<StericExcess> excess = std::nullopt);
  void expect_exact_inverse(std::optional<StericExcess> excess);

  ScaledGrid grid = test::small_grid();
  std::vector<double> start, fixed, residual;
  StageProblem problem;
  parallel::WorkerTeam team{1};
};

TEST_F(Equations, RestIsASolution) {
  TransportEquations equations(grid, team);
  IonState rest(grid.nodes());
  std::ranges::fill(rest.concentration(), 1.0);
  equations.residual({start, 5.0, start, 0.0, 0.0}, rest, residual);
  for (const double value : residual) {
    EXPECT_EQ(value, 0.0);
  }
  TransportEquations(grid, team, StericExcess{0.5})
      .residual({start, 5.0, start, 0.0, 0.0}, rest, residual);
  for (const double value : residual) {
    EXPECT_EQ(value, 0.0);
  }
}

TEST_F(Equations, FluxesMoveIonsWithoutLosingAny) {
  TransportEquations equations(grid, team);
  const IonState state = test::wavy_state(grid);
  equations.residual(problem, state, residual);
  double balance = 0.0, gained = 0.0;
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    balance += residual[i];
    gained += grid.height[i / grid.columns()] * (state.concentration()[i] - start[i]);
  }
  EXPECT_NEAR(balance, gained, 1e-12);
}

TEST_F(Equations, JacobianAgreesWithDifferences) {
  expect_exact_jacobian();
}

TEST_F(Equations, JacobianOfAClosedCircuitAgreesWithDifferences) {
  problem.circuit = CircuitStage{0.1, 0.02};
  expect_exact_jacobian();
}

TEST_F(Equations, JacobianOfStericIonsAgreesWithDifferences) {
  expect_exact_jacobian(StericExcess{0.5});
}

void Equations::expect_exact_jacobian(std::optional<StericExcess> excess) {
  TransportEquations equations(grid, team, excess);
  const IonState state = test::wavy_state(grid);
  IonState direction(grid.nodes());
  for (std::size_t i = 0; i < direction.values.size(); ++i) {
    direction.values[i] = std::sin(1.3 * static_cast<double>(i) + 0.2);
  }
  std::vector<double> change(2 * grid.nodes()), plus(change), minus(change);
  equations.linearise(problem, state);
  equations.apply_jacobian(direction.values, change);
  const double step = 1e-6;
  for (const double sign : {1.0, -1.0}) {
    IonState shifted = state;
    for (std::size_t i = 0; i < shifted.values.size(); ++i) {
      shifted.values[i] += sign * step * direction.values[i];
    }
    equations.residual(problem, shifted, sign > 0 ? plus : minus);
  }
  for (std::size_t i = 0; i < change.size(); ++i) {
    EXPECT_NEAR(change[i], (plus[i] - minus[i]) / (2.0 * step), 1e-8) << i;
  }
}

TEST_F(Equations, PreconditionerInvertsTheJacobianOfALaterallyUniformState) {
  expect_exact_inverse(std::nullopt);
}

TEST_F(Equations, PreconditionerInvertsThatOfStericIonsToo) {
  expect_exact_inverse(StericExcess{0.5});
}

void Equations::expect_exact_inverse(std::optional<StericExcess> excess) {
  const IonState wavy = test::wavy_state(grid);
  IonState state(grid.nodes());
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    const std::size_t first = i / grid.columns() * grid.columns();
    state.concentration()[i] = wavy.concentration()[first];
    state.potential()[i] = wavy.potential()[first];
  }
  TransportEquations equations(grid, team, excess);
  FastDiagonalisation preconditioner(grid, team, excess);
  equations.linearise(problem, state);
  preconditioner.factorise(state, problem.step);
  const IonState direction = test::wavy_state(grid);
  std::vector<double> image(2 * grid.nodes()), back(image);
  equations.apply_jacobian(direction.values, image);
  preconditioner.apply(image, back);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_NEAR(back[i], direction.values[i], 1e-5) << i;
  }
}

TEST_F(Equations, ClosedPreconditionerDoesSoWithACircuit) {
  IonState state(grid.nodes());
  std::ranges::fill(state.concentration(), 1.2);
  problem.circuit = CircuitStage{0.1, 0.02};
  TransportEquations equations(grid, team);
  ClosedPreconditioner preconditioner(grid, team);
  equations.linearise(problem, state);
  preconditioner.factorise(state, problem.step);
  const IonState direction = test::wavy_state(grid);
  std::vector<double> image(2 * grid.nodes()), back(image);
  equations.apply_jacobian(direction.values, image);
  preconditioner.apply(problem, image, back);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_NEAR(back[i], direction.values[i], 3e-5) << i;
  }
}

/// One conductor held, two behind circuits, a column shared by two of them.
TEST_F(Equations, ClosedPreconditionerDoesSoWithConductors) {
  const std::size_t columns = grid.columns();
  std::vector<WallConductor> conductors(
      3, WallConductor{std::vector<double>(columns, 0.0), ScaledAdmittance{}});
  for (std::size_t i = 0; i < columns; ++i) {
    conductors[3 * i / columns].share[i] = 1.0;
  }
  conductors[0].share[0] = 0.25;
  conductors[1].share[0] = 0.75;
  const WallElectrodes electrodes(std::move(conductors));
  const double held = std::numeric_limits<double>::infinity();
  const ElectrodeStage stage{{0.1, 0.2, 0.3}, {0.02, held, 0.0}};
  problem.electrodes = &stage;

  IonState state(grid.nodes());
  std::ranges::fill(state.concentration(), 1.2);
  TransportEquations equations(grid, team, std::nullopt, &electrodes);
  ClosedPreconditioner preconditioner(grid, team, std::nullopt, &electrodes);
  equations.linearise(problem, state);
  preconditioner.factorise(state, problem.step);
  IonState direction = test::wavy_state(grid);
  electrodes.spread(std::vector{0.7, 0.0, -0.4}, direction.potential().last(columns));
  std::vector<double> image(2 * grid.nodes()), back(image);
  equations.apply_jacobian(direction.values, image);
  preconditioner.apply(problem, image, back);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_NEAR(back[i], direction.values[i], 3e-5) << i;
  }
}

/// Conductors on both walls, at an evenly charged state, where the preconditioner is exact but for
/// single precision.
TEST_F(Equations, PreconditionerInvertsTheJacobianOfCrossedLines) {
  const std::size_t columns = grid.columns();
  std::vector<WallConductor> conductors(
      5, WallConductor{std::vector<double>(columns, 0.0), ScaledAdmittance{}});
  for (std::size_t i = 0; i < columns; ++i) {
    conductors[3 * (i % grid.columns_x) / grid.columns_x].share[i] = 1.0;
    conductors[3 + 2 * (i / grid.columns_x) / grid.columns_y].share[i] = 1.0;
  }
  conductors[3].wall = conductors[4].wall = bottom_wall;
  const WallElectrodes electrodes(std::move(conductors));
  const double held = std::numeric_limits<double>::infinity();
  const ElectrodeStage stage{{0.1, 0.2, 0.3, 0.0, 0.1}, {0.02, 0.5, 0.0, held, 0.0}};
  problem.electrodes = &stage;

  IonState state(grid.nodes());
  std::ranges::fill(state.concentration(), 1.2);
  TransportEquations equations(grid, team, std::nullopt, &electrodes);
  ClosedPreconditioner preconditioner(grid, team, std::nullopt, &electrodes);
  equations.linearise(problem, state);
  preconditioner.factorise(state, problem.step);
  IonState direction = test::wavy_state(grid);
  electrodes.spread(std::vector{0.7, 0.3, -0.4, 0.0, 0.9}, direction.potential());
  std::vector<double> image(2 * grid.nodes()), back(image);
  equations.apply_jacobian(direction.values, image);
  preconditioner.apply(problem, image, back);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_NEAR(back[i], direction.values[i], 3e-5) << i;
  }
}

/// The charge of one line by the potential of another is the same both ways.
TEST_F(Equations, LinesAreReciprocal) {
  const std::size_t columns = grid.columns();
  std::vector<WallConductor> conductors(
      4, WallConductor{std::vector<double>(columns, 0.0), ScaledAdmittance{}});
  for (std::size_t i = 0; i < columns; ++i) {
    conductors[i % grid.columns_x < 2 ? 0 : 1].share[i] = 1.0;
    conductors[i / grid.columns_x < 1 ? 2 : 3].share[i] = 1.0;
  }
  conductors[2].wall = conductors[3].wall = bottom_wall;
  const WallElectrodes electrodes(std::move(conductors));
  FastDiagonalisation cell(grid, team, std::nullopt, &electrodes);
  IonState rest(grid.nodes());
  std::ranges::fill(rest.concentration(), 1.0);
  for (const double step : {0.0, 0.1, 1e4}) {
    cell.factorise(rest, step);
    const std::vector<double>& y = cell.electrode_admittance();
    for (std::size_t a = 0; a < 4; ++a) {
      double all_alike = 0;
      for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_NEAR(y[4 * a + b], y[4 * b + a], 1e-11 * y[0]) << a << b;
        all_alike += y[4 * a + b];
      }
      // One potential everywhere moves no charge; modes are in single precision.
      EXPECT_NEAR(all_alike, 0, 1e-7 * y[0]);
    }
  }
}

TEST_F(Equations, ThreadsDoNotChangeABit) {
  const IonState state = test::wavy_state(grid);
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    parallel::WorkerTeam workers(threads);
    TransportEquations equations(grid, workers);
    FastDiagonalisation preconditioner(grid, workers);
    preconditioner.factorise(state, problem.step);
    equations.residual(problem, state, residual);
    equations.linearise(problem, state);
    results.emplace_back(2 * grid.nodes());
    preconditioner.apply(residual, results.back());
    equations.apply_jacobian(std::vector<double>(results.back()), results.back());
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

} // namespace
} // namespace ionskin::electrochemistry
