// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/steric_excess.hpp"

#include "ionskin/electrochemistry/equations/exact_average.hpp"
#include "ionskin/electrochemistry/equations/ion_flux.hpp"
#include "ionskin/electrochemistry/equations/lateral_flux.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"
#include "model_cases.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

constexpr StericExcess crowding{0.4};

TEST(StericExcess, IsTheLogarithmOfTheRoomAndItsSlope) {
  EXPECT_DOUBLE_EQ(crowding.excess(1.0), -std::log(0.6));
  EXPECT_NEAR(crowding.slope(2.0),
              (crowding.excess(2.0 + 1e-6) - crowding.excess(2.0 - 1e-6)) / 2e-6, 1e-8);
  // The excess at little filling is c/c_max.
  EXPECT_NEAR(StericExcess{1e-12}.excess(3.0), 3e-12, 1e-23);
}

TEST(StericExcess, ComesFromTheLargestConcentrationOfACase) {
  Case input = verification::model_case();
  EXPECT_FALSE(steric_excess(input.electrochemistry));
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.largest_concentration = 2400.0;
  EXPECT_DOUBLE_EQ(steric_excess(input.electrochemistry)->filling, 0.5);
  input.electrochemistry.valence = 2;
  EXPECT_DOUBLE_EQ(steric_excess(input.electrochemistry)->filling, 0.25);
}

TEST(StericExcess, DriveChangesAsItsDerivativeSays) {
  const std::array<double, 3> c{0.2, 1.0, 2.4}, phi{0.1, -2.0, 3.0}, dc{0.3, -1.0, 0.05},
      dphi{1.0, 0.5, -2.0};
  std::array<double, 3> change{}, plus{}, minus{};
  crowding.drive_change(c, dc, dphi, change);
  const double step = 1e-6;
  for (const double sign : {1.0, -1.0}) {
    std::array<double, 3> c2{}, phi2{};
    for (std::size_t i = 0; i < 3; ++i) {
      c2[i] = c[i] + sign * step * dc[i];
      phi2[i] = phi[i] + sign * step * dphi[i];
    }
    crowding.drive(c2, phi2, sign > 0 ? plus : minus);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(change[i], (plus[i] - minus[i]) / (2.0 * step), 1e-8);
  }
}

TEST(StericExcess, ChangesLeaveAShareOfTheRoom) {
  const std::vector<double> before{0.5, 2.4, 1.0};
  std::vector<double> after{0.6, 9.0, 2.45};
  EXPECT_FALSE(crowding.leaves_room(before, after, 0.1));
  crowding.keep_room(before, after, 0.1);
  EXPECT_EQ(after[0], 0.6);
  EXPECT_NEAR(crowding.room(after[1]), 0.1 * crowding.room(2.4), 1e-15);
  EXPECT_NEAR(crowding.room(after[2]), 0.1 * crowding.room(1.0), 1e-15);
  EXPECT_TRUE(crowding.leaves_room(before, after, 0.0999));
  EXPECT_FALSE(crowding.leaves_room(before, std::vector{0.5, std::nan(""), 1.0}, 0.1));
}

TEST(StericExcess, FluxVanishesInEquilibrium) {
  // c / (1 - filling c) exp(phi) is the same at both ends.
  const std::array<double, 2> phi{0.3, -2.7};
  std::array<double, 2> c{}, drive{}, flux{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double ratio = 1.7 * std::exp(-phi[i]);
    c[i] = ratio / (1.0 + crowding.filling * ratio);
  }
  crowding.drive(c, phi, drive);
  ThicknessFlux(1).evaluate(std::span(c).first(1), std::span(c).last(1), std::span(drive).first(1),
                            std::span(drive).last(1), 0.3, std::span(flux).first(1));
  EXPECT_NEAR(flux[0], 0.0, 1e-14);
}

TEST(StericExcess, LateralIonsFollowTheDriveAndTheFieldThePotential) {
  const ScaledGrid grid = test::small_grid();
  const IonState state = test::wavy_state(grid);
  const std::size_t columns = grid.columns();
  const auto c = state.concentration().first(columns), phi = state.potential().first(columns);
  std::vector<double> drive(columns), ions(columns), field(columns), driven(columns),
      unused(columns);
  crowding.drive(c, phi, drive);
  LateralFlux lateral(grid);
  lateral.inflow(c, drive, phi, driven, field);
  lateral.inflow(c, drive, drive, ions, unused);
  EXPECT_EQ(driven, ions);
  lateral.inflow(c, phi, phi, ions, unused);
  EXPECT_EQ(field, unused);
}

TEST(StericExcess, ExactAverageRestoresIonsWithinTheirBounds) {
  const ScaledGrid grid = test::small_grid();
  IonState state = test::wavy_state(grid);
  const std::vector<double> start(grid.nodes(), 1.0);
  const double amount = ExactAverage::total(grid, start);
  state.concentration()[7] = (1.0 - 1e-9) / crowding.filling;
  ExactAverage(grid, crowding).correct({start, 1.0, start, 0.0, 0.0, amount}, state);
  EXPECT_NEAR(ExactAverage::total(grid, state.concentration()), amount, 1e-13 * amount);
  EXPECT_GT(crowding.room(state.concentration()[7]), 0.0);
}

TEST(StericExcess, StrongFieldsFillTheLayerWithoutOverflow) {
  const ScaledGrid grid = test::small_grid();
  std::vector<double> start(grid.nodes(), 1.0), fixed(grid.nodes());
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    fixed[i] = 1.0 + 0.5 * std::sin(0.9 * static_cast<double>(i));
  }
  IonState state(grid.nodes());
  std::ranges::fill(state.concentration(), 1.0);
  const double amount = ExactAverage::total(grid, start);
  const StageProblem problem{start, 20.0, fixed, -4.0, 4.0, amount};
  parallel::WorkerTeam team{1};
  NewtonKrylov newton(grid, 1e-7, team, crowding);
  newton.prepare(state, problem.step);
  ASSERT_TRUE(newton.solve(problem, state));
  std::vector<double> residual(2 * grid.nodes());
  TransportEquations(grid, team, crowding).residual(problem, state, residual);
  EXPECT_LT(std::abs(*std::ranges::max_element(residual)), 1e-5);
  EXPECT_LT(std::abs(*std::ranges::min_element(residual)), 1e-5);
  EXPECT_GT(std::ranges::min(state.concentration()), 0.0);
  EXPECT_LT(std::ranges::max(state.concentration()), 1.0 / crowding.filling);
  EXPECT_GT(std::ranges::max(state.concentration()), 0.9 / crowding.filling);
  EXPECT_NEAR(ExactAverage::total(grid, state.concentration()), amount, 1e-13 * amount);
  EXPECT_LT(newton.counters().krylov_iterations, 200U);
}

TEST(StericExcess, ARunResumesBitForBit) {
  Case input = verification::model_case();
  input.numerics.preset = Preset::coarse;
  input.coupling.coefficient = 0.5;
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.largest_concentration = 2000.0;
  const auto history = verification::linear_step_history(0.0, 0.02, {0.0, 0.5});
  std::vector<IonCheckpoint> saved;
  IonOptions options;
  options.checkpoint_interval = 5;
  options.checkpoint_seconds = 0;
  options.checkpoint = [&saved](const IonCheckpoint& state) { saved.push_back(state); };
  base::Timers timers;
  const IonSolution whole = solve_ion_transport(input, history, options, timers);
  ASSERT_GE(saved.size(), 2U);
  IonOptions later;
  later.resume = saved[1];
  const IonSolution rest = solve_ion_transport(input, history, later, timers);
  EXPECT_EQ(rest.time, whole.time);
  EXPECT_EQ(rest.charge_top, whole.charge_top);
  EXPECT_EQ(rest.krylov_iterations, whole.krylov_iterations);
}

} // namespace
} // namespace ionskin::electrochemistry
