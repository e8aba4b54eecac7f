// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"

#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/solver/preconditioner.hpp"
#include "model_cases.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

namespace ionskin::electrochemistry {
namespace {

using verification::model_case;
using verification::slide_onset_history;

IonSolution solve(const Case& input, const IonOptions& options = {}) {
  base::Timers timers;
  return solve_ion_transport(input, slide_onset_history(), options, timers);
}

Case with_metal(double bottom, double top, const char* circuit = "short") {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.skin.layers.front().sheet_resistance = bottom;
  input.skin.layers.back().sheet_resistance = top;
  input.readout.circuit = circuit;
  input.readout.parameters = {{"load_resistance", 300.0}, {"load_capacitance", 1e-4}};
  return input;
}

const SheetElectrodes::Contact at_both_ends{{0, 4}, {0, 1, 2}, {1, 1, 1}};
const SheetElectrodes::Contact at_a_corner{{0}, {0, 1}, {1, 0.4}};

TEST(SheetElectrodes, WhatComesToTheColumnsComesFromTheLead) {
  const ScaledGrid grid = test::small_grid();
  const SheetElectrodes metal(grid, {300.0, 500.0}, at_a_corner, std::nullopt);
  std::vector<double> potential(grid.columns()), charge(grid.columns(), 0.0);
  for (std::size_t i = 0; i < potential.size(); ++i) {
    potential[i] = std::sin(0.9 * static_cast<double>(i));
  }
  constexpr double lead = 0.7, step = 0.2;
  metal.take_inflow(top_wall, step, potential, lead, charge);
  double expected = 0.0;
  const std::vector<double> contact = metal.contact_conductance(top_wall);
  for (std::size_t i = 0; i < contact.size(); ++i) {
    expected -= step * contact[i] * (lead - potential[metal.touched()[i]]);
  }
  EXPECT_NEAR(std::accumulate(charge.begin(), charge.end(), 0.0), expected, 1e-12);
}

/// About a state that is the same in every column the preconditioner is the inverse of the
/// Jacobian, but for single precision.
TEST(SheetElectrodes, ThePreconditionerKnowsMetalLeadsAndCircuit) {
  const ScaledGrid grid = test::small_grid();
  IonState state(grid.nodes());
  std::ranges::fill(state.concentration(), 1.0);
  const std::vector<double> start(grid.nodes(), 1.0), fixed(grid.nodes(), 1.0);
  constexpr double step = 0.3;
  parallel::WorkerTeam team(2);
  for (const auto& contact : {at_both_ends, at_a_corner}) {
    for (const auto& circuit :
         {std::optional<ScaledAdmittance>{}, std::optional(ScaledAdmittance{0.0, 0.0}),
          std::optional(ScaledAdmittance{0.05, 0.02})}) {
      const SheetElectrodes metal(grid, {300.0, 1500.0}, contact, circuit);
      SheetStage stage{
          {std::vector<double>(grid.columns(), 0.0), std::vector<double>(grid.columns(), 0.0)},
          0.0,
          step,
          std::nullopt};
      if (circuit) {
        stage.circuit = CircuitStage{0.0, metal.circuit_conductance(step)};
      }
      const StageProblem problem{
          .start = start, .step = step, .fixed_charge = fixed, .ion_amount = 1.0, .sheets = &stage};
      TransportEquations equations(grid, team, std::nullopt, nullptr, &metal);
      equations.linearise(problem, state);
      FastDiagonalisation inverse(grid, team, std::nullopt, nullptr, &metal);
      inverse.factorise(state, step);
      const IonState direction = test::wavy_state(grid);
      std::vector<double> image(2 * grid.nodes()), back(image.size());
      equations.apply_jacobian(direction.values, image);
      inverse.apply(image, back);
      for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_NEAR(back[i], direction.values[i], 2e-4) << i;
      }
    }
  }
}

TEST(SheetElectrodes, MetalThatIsTouchedEverywhereChangesNoBit) {
  const IonSolution none = solve(with_metal(0.0, 0.0));
  Case everywhere = with_metal(2.0, 3.0);
  everywhere.readout.contact = ElectrodeContact::everywhere;
  const IonSolution same = solve(everywhere);
  EXPECT_EQ(none.time, same.time);
  EXPECT_EQ(none.charge_top, same.charge_top);
  EXPECT_TRUE(same.metal_drop.empty());
}

TEST(SheetElectrodes, NextToNoResistanceIsNone) {
  for (const char* circuit : {"short", "load", "parallel-rc"}) {
    const IonSolution none = solve(with_metal(0.0, 0.0, circuit)),
                      little = solve(with_metal(1e-5, 0.0, circuit));
    EXPECT_NEAR(little.charge_top.back(), none.charge_top.back(),
                1e-3 * base::largest_magnitude(none.charge_top))
        << circuit;
    EXPECT_NEAR(little.voltage.back(), none.voltage.back(),
                2e-3 * base::largest_magnitude(none.voltage))
        << circuit;
  }
}

TEST(SheetElectrodes, ResistanceDelaysTheChargeAndConservesIt) {
  Case input = with_metal(5.0, 5.0);
  input.coupling.law = "column-neutral";
  const IonSolution slow = solve(input);
  input.skin.layers.front().sheet_resistance = input.skin.layers.back().sheet_resistance = 0.0;
  const IonSolution fast = solve(input);
  const double scale = base::largest_magnitude(fast.charge_top);
  EXPECT_LT(base::largest_magnitude(slow.charge_top), 0.7 * scale);
  EXPECT_GT(base::largest_magnitude(slow.metal_drop), 0.0);
  for (std::size_t row = 0; row < slow.time.size(); ++row) {
    EXPECT_NEAR(slow.charge_top[row] + slow.charge_bottom[row], 0.0, 1e-10 * scale);
  }
  input = with_metal(5.0, 5.0, "open");
  input.coupling.law = "column-neutral";
  const IonSolution open = solve(input);
  EXPECT_LT(base::largest_magnitude(open.charge_top), 1e-10 * scale);
  EXPECT_GT(base::largest_magnitude(open.voltage), 0.0);
}

TEST(SheetElectrodes, AResumedRunHasTheSameBits) {
  for (const char* circuit : {"short", "parallel-rc"}) {
    const Case input = with_metal(1.0, 2.0, circuit);
    const IonSolution whole = solve(input);
    std::optional<IonCheckpoint> kept;
    IonOptions options;
    options.checkpoint_interval = 7;
    options.checkpoint_seconds = 0;
    options.checkpoint = [&kept](const IonCheckpoint& state) {
      if (!kept) {
        kept = state;
      }
    };
    solve(input, options);
    options = {};
    options.resume = kept;
    const IonSolution resumed = solve(input, options);
    EXPECT_EQ(whole.time, resumed.time);
    EXPECT_EQ(whole.charge_top, resumed.charge_top);
    EXPECT_EQ(whole.voltage, resumed.voltage);
    EXPECT_EQ(whole.metal_drop, resumed.metal_drop);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
