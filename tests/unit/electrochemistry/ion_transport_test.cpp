// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/ion_transport.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "model_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <string_view>

namespace ionskin::electrochemistry {
namespace {

using verification::linear_step_history;
using verification::model_case;
using verification::slide_onset_history;

IonSolution solve(const Case& input, const history::CoreHistory& history,
                  const IonOptions& options = {}) {
  base::Timers timers;
  return solve_ion_transport(input, history, options, timers);
}

Case coarse_case() {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  return input;
}

void expect_equal(const IonSolution& a, const IonSolution& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.charge_top, b.charge_top);
  EXPECT_EQ(a.charge_bottom, b.charge_bottom);
  EXPECT_EQ(a.ion_amount, b.ion_amount);
  EXPECT_EQ(a.min_concentration, b.min_concentration);
  EXPECT_EQ(a.column_charge_top, b.column_charge_top);
  EXPECT_EQ(a.krylov_iterations, b.krylov_iterations);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
    EXPECT_EQ(a.snapshots[i].potential, b.snapshots[i].potential);
  }
}

TEST(IonTransport, ThreadsDoNotChangeABit) {
  const auto history = slide_onset_history();
  IonOptions one, three;
  one.snapshot_times = three.snapshot_times = {0.55};
  three.threads = 3;
  expect_equal(solve(coarse_case(), history, one), solve(coarse_case(), history, three));
}

TEST(IonTransport, InterruptedAndResumedEqualsUninterrupted) {
  const auto history = slide_onset_history();
  IonOptions options;
  options.snapshot_times = {0.2, 0.55};
  const IonSolution whole = solve(coarse_case(), history, options);

  struct Stop : std::exception {};
  IonCheckpoint kept;
  IonOptions first = options;
  first.checkpoint_interval = 20;
  first.checkpoint_seconds = 0;
  first.checkpoint = [&kept](const IonCheckpoint& checkpoint) {
    kept = checkpoint;
    throw Stop();
  };
  EXPECT_THROW(solve(coarse_case(), history, first), Stop);
  EXPECT_EQ(kept.step, 20U);
  EXPECT_EQ(kept.solution.time.size(), 21U);

  IonOptions second = options;
  second.resume = kept;
  expect_equal(whole, solve(coarse_case(), history, second));
}

TEST(IonTransport, StepsThatGetNowhereEndAndCanBeResumed) {
  const auto history = slide_onset_history();
  const IonSolution whole = solve(coarse_case(), history);

  IonCheckpoint kept;
  IonOptions first;
  first.checkpoint = [&kept](const IonCheckpoint& checkpoint) { kept = checkpoint; };
  first.most_work = 20; // the steps behind an event take more
  try {
    solve(coarse_case(), history, first);
    FAIL() << "no end";
  } catch (const SolverError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("makes no progress"));
    EXPECT_THAT(error.remedy(), testing::HasSubstr("coupling.coefficient"));
  }
  EXPECT_GT(kept.step, 0U);
  EXPECT_LT(kept.solution.time.back(), history.time.back());

  IonOptions second;
  second.resume = kept;
  expect_equal(whole, solve(coarse_case(), history, second));
}

/// Double layers of half a nanometre, strained within microseconds: potentials of thousands of
/// thermal voltages crowd the ions at the walls below the slider, and nowhere else.
TEST(IonTransport, IonsThatCrowdInSomeColumnsTakeFewSteps) {
  Case input = coarse_case();
  input.numerics.mesh_refinement = 0.3;
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.valence = 2;
  input.electrochemistry.fixed_charge_concentration = 902;
  input.electrochemistry.largest_concentration = 1271;
  input.electrochemistry.diffusivity = 3.7e-13;
  input.electrochemistry.permittivity = 6.8e-10;
  input.coupling.coefficient = -3e-4;
  history::CoreHistory history = slide_onset_history();
  for (double& time : history.time) {
    time *= 2e-5;
  }
  for (double& time : history.event_time) {
    time *= 2e-5;
  }
  IonOptions options;
  options.most_work = 20'000; // lest it takes for ever
  const IonSolution solution = solve(input, history, options);
  EXPECT_EQ(solution.time.back(), history.time.back());
  EXPECT_LT(solution.residual_evaluations + solution.krylov_iterations, 1000U);
}

TEST(IonTransport, QuickRunsKeepTheirEndAlone) {
  IonOptions options;
  options.checkpoint_interval = 1;
  options.checkpoint_seconds = 3600;
  std::vector<double> kept;
  options.checkpoint = [&](const IonCheckpoint& checkpoint) {
    kept.push_back(checkpoint.solution.time.back());
  };
  solve(coarse_case(), linear_step_history(-0.01, 0.01, {0.0, 1.0}), options);
  EXPECT_EQ(kept, std::vector<double>{1.0});
}

TEST(IonTransport, CheckpointOfAnotherCaseIsRefused) {
  const auto history = linear_step_history(-0.01, 0.01, {0.0, 1.0});
  IonOptions options;
  IonCheckpoint kept;
  options.checkpoint_interval = 5;
  options.checkpoint_seconds = 0;
  options.checkpoint = [&kept](const IonCheckpoint& checkpoint) { kept = checkpoint; };
  solve(coarse_case(), history, options);
  IonOptions resumed;
  resumed.resume = kept;
  EXPECT_NO_THROW(solve(coarse_case(), history, resumed));
  EXPECT_THROW(solve(model_case(), history, resumed), UserError);
}

TEST(IonTransport, SnapshotsAreInSiUnitsAtTheWantedInstants) {
  Case input = coarse_case();
  input.electrochemistry.valence = 2;
  IonOptions options;
  options.snapshot_times = {0.25, 99.0};
  const auto solution = solve(input, linear_step_history(-0.02, 0.02, {0.0, 1.0}), options);
  ASSERT_EQ(solution.snapshots.size(), 2U);
  EXPECT_EQ(solution.snapshots[0].time, 0.25);
  EXPECT_EQ(solution.snapshots[1].time, 1.0);
  const IonSnapshot& snapshot = solution.snapshots[0];
  ASSERT_EQ(snapshot.concentration.size(), solution.grid.z_nodes.size());
  const std::size_t middle = snapshot.concentration.size() / 2;
  EXPECT_NEAR(snapshot.concentration[middle], 600.0, 1.0);
  EXPECT_NEAR(snapshot.shear[middle], 0.0, 1e-12);
  const double largest = *std::ranges::max_element(snapshot.potential);
  EXPECT_GT(largest, 1e-4);
  EXPECT_LE(largest, *std::ranges::max_element(solution.max_potential));
}

TEST(IonTransport, UniformShearChargesBothElectrodesAlikeAtOnce) {
  const auto solution = solve(coarse_case(), linear_step_history(1e-3, 1e-3, {0.0, 1.0}));
  const double expected = 1.04204 * 15e-3 * 2e-3;
  for (std::size_t i = 0; i < solution.time.size(); ++i) {
    EXPECT_NEAR(solution.charge_top[i], expected, 1e-5 * expected);
    EXPECT_NEAR(solution.charge_bottom[i], expected, 1e-5 * expected);
  }
}

Case beside_capacitor(double load_resistance, double load_capacitance) {
  Case input = coarse_case();
  input.readout.circuit = "parallel-rc";
  input.readout.parameters = {{"load_resistance", load_resistance},
                              {"load_capacitance", load_capacitance}};
  return input;
}

TEST(IonTransport, RelaxationFollowsTheChargeWhereTheShearRests) {
  const auto history = linear_step_history(-0.01, 0.01, {0.0, 1.0});
  Case loaded = coarse_case();
  loaded.readout.circuit = "load";
  loaded.readout.parameters = {{"load_resistance", 20.0}};
  for (const Case& input : {coarse_case(), loaded, beside_capacitor(20.0, 5e-3)}) {
    const auto solution = solve(input, history);
    const auto difference = [&](std::size_t i) {
      return 0.5 * (solution.charge_top[i] - solution.charge_bottom[i]);
    };
    const double largest = std::abs(solution.relaxation_charge.back());
    for (std::size_t i = 1; i < solution.time.size(); ++i) {
      const double gained = solution.relaxation_charge[i] - solution.relaxation_charge[i - 1];
      EXPECT_NEAR(gained, difference(i) - difference(i - 1), 1e-9 * largest);
      if (solution.time[i - 1] > 0.1) {
        const double rate =
            0.5 * (solution.relaxation_current[i - 1] + solution.relaxation_current[i]);
        EXPECT_NEAR(gained / (solution.time[i] - solution.time[i - 1]), rate,
                    0.01 * std::abs(rate));
      }
    }
  }
}

TEST(IonTransport, ResistorBesideNoCapacitorIsALoad) {
  const auto history = linear_step_history(-0.01, 0.01, {0.0, 1.0});
  Case load = beside_capacitor(20.0, 0.0);
  const auto without = solve(load, history);
  load.readout.circuit = "load";
  const auto loaded = solve(load, history);
  EXPECT_EQ(without.time, loaded.time);
  EXPECT_EQ(without.charge_top, loaded.charge_top);
  EXPECT_EQ(without.voltage, loaded.voltage);
  EXPECT_EQ(without.relaxation_charge, loaded.relaxation_charge);
}

TEST(IonTransport, LargeCapacitorIsAShortCircuit) {
  const auto history = linear_step_history(-0.01, 0.01, {0.0, 1.0});
  const auto capacitor = solve(beside_capacitor(1e18, 1e5), history);
  const auto shorted = solve(coarse_case(), history);
  EXPECT_NEAR(capacitor.charge_top.back(), shorted.charge_top.back(),
              1e-4 * std::abs(shorted.charge_top.back()));
  EXPECT_LT(std::abs(capacitor.voltage.back()), 1e-6);
}

TEST(IonTransport, VoltageDecaysWithTheCapacitancesOfCircuitAndCell) {
  const Case plain = coarse_case();
  const auto scales = derive_scales(plain.electrochemistry, plain.skin.core_thickness());
  const double cell = plain.electrochemistry.permittivity * plain.skin.length * plain.skin.width /
                      (2 * scales.debye_length);
  // The decay is so slow that both double layers follow at once, in the linear range.
  const double decay = 200 * scales.slow_time;
  const auto solution = solve(beside_capacitor(decay / (2 * cell), cell),
                              linear_step_history(-1e-5, 1e-5, {0.0, decay}));
  const auto begin = std::ranges::find_if(solution.time, [&](double t) { return t > 0.2 * decay; });
  ASSERT_NE(begin, solution.time.end());
  const auto row = static_cast<std::size_t>(begin - solution.time.begin());
  EXPECT_GT(std::abs(solution.voltage[row]), 0);
  EXPECT_NEAR(solution.voltage.back() / solution.voltage[row],
              std::exp(-(solution.time.back() - *begin) / decay), 0.01);
}

TEST(IonTransport, ColumnChargesAddUpToTheLastRow) {
  const auto solution = solve(coarse_case(), slide_onset_history());
  double sum = 0.0;
  for (const double charge : solution.column_charge_top) {
    sum += charge;
  }
  EXPECT_NEAR(sum, solution.charge_top.back(), 1e-12 * std::abs(sum));
}

TEST(IonTransport, ElectrodePotentialsChargeTheGeometricCapacitanceAtOnce) {
  Case input = coarse_case();
  IonOptions options;
  options.potentials.top = [](double) { return 1e-3; };
  const auto solution = solve(input, linear_step_history(0.0, 0.0, {0.0, 0.1}), options);
  const double area = 15e-3 * 2e-3;
  EXPECT_NEAR(solution.charge_top[0], 2e-3 / 180e-6 * 1e-3 * area, 1e-6 * 11.11e-3 * area);
  EXPECT_NEAR(solution.charge_bottom[0], -solution.charge_top[0], 1e-11 * solution.charge_top[0]);
  EXPECT_GT(solution.charge_top.back(), 5.0 * solution.charge_top[0]);
}

TEST(IonTransport, NegativeFixedChargeStopsTheRunAndHandsOverWhatItHas) {
  auto history = linear_step_history(0.0, 0.0, {0.0, 0.5, 1.0});
  history.shear()[2] =
      std::make_shared<const history::StrainField>(history::StrainField{0.0, -20.0});
  IonOptions options;
  std::size_t rows = 0;
  options.checkpoint = [&rows](const IonCheckpoint& checkpoint) {
    rows = checkpoint.solution.time.size();
  };
  EXPECT_THROW(solve(coarse_case(), history, options), SolverError);
  EXPECT_GT(rows, 5U);
}

TEST(IonTransport, ShortensAStepThatNewtonCannotTake) {
  IonOptions options;
  options.potentials.top = [](double time) { return time > 0.0 ? 25.0 : 0.0; };
  const auto solution = solve(coarse_case(), linear_step_history(0.0, 0.0, {0.0, 0.05}), options);
  EXPECT_GT(solution.rejected_steps, 0U);
  EXPECT_GT(solution.min_concentration.back(), 0.0);
}

TEST(IonTransport, GivesUpWithTheInstantAndARemedy) {
  IonOptions options;
  options.potentials.top = [](double time) { return time > 0.01 ? std::nan("") : 0.0; };
  try {
    solve(coarse_case(), linear_step_history(0.0, 0.0, {0.0, 0.05}), options);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("between t = 0.0"), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find("coupling.coefficient"), std::string::npos);
  }
}

TEST(IonTransport, DeepDepletionStaysPositiveAndKeepsTheIdentities) {
  Case input = coarse_case();
  input.coupling.coefficient = 1.0;
  const auto solution = solve(input, linear_step_history(0.0, 5.0, {0.0, 1.0}));
  const double expected = solution.charge_top[0] + solution.charge_bottom[0];
  for (std::size_t i = 0; i < solution.time.size(); ++i) {
    EXPECT_GT(solution.min_concentration[i], 0.0);
    EXPECT_NEAR(solution.charge_top[i] + solution.charge_bottom[i], expected, 1e-11 * expected);
    EXPECT_NEAR(solution.ion_amount[i], solution.ion_amount[0], 1e-12 * solution.ion_amount[0]);
  }
  EXPECT_LT(solution.min_concentration.back(), 1e-3);
}

TEST(IonTransport, PairGenerationKeepsTheCoreNeutralAndCountsTheReleasedIons) {
  Case input = coarse_case();
  input.coupling.law = "pair-generation";
  const auto solution = solve(input, slide_onset_history());
  const double unit = input.coupling.coefficient * 1200.0;
  for (std::size_t i = 0; i < solution.time.size(); ++i) {
    const double released = unit * solution.shear_integral[i];
    EXPECT_NEAR(solution.ion_amount[i], solution.ion_amount[0] + released,
                1e-12 * solution.ion_amount[0]);
    EXPECT_NEAR(solution.charge_top[i] + solution.charge_bottom[i], 0.0, 1e-14);
  }
  EXPECT_GT(std::abs(solution.charge_top.back()), 1e-9);
}

TEST(IonTransport, DebyeLayersOfNanometresStayPositive) {
  Case input = coarse_case();
  input.electrochemistry.permittivity = 7.1e-10;
  input.coupling.coefficient = 1e-3;
  for (const auto law : {"column-neutral", "pair-generation"}) {
    input.coupling.law = law;
    auto history = linear_step_history(0.0, 0.0, {0.0, 0.1, 0.1005, 0.2});
    history.shear()[2] =
        std::make_shared<const history::StrainField>(history::StrainField{0.0, 0.1});
    history.shear()[3] = history.shear()[2];
    history.event_time = {0.1, 0.1005};
    const auto solution = solve(input, history);
    EXPECT_GT(std::ranges::min(solution.min_concentration), 0.0);
    EXPECT_NE(solution.charge_top.back(), 0.0);
    EXPECT_LT(solution.steps, 250U);
  }
}

TEST(IonTransport, ProgressReachesOne) {
  IonOptions options;
  double last = 0.0;
  options.progress = [&last](std::string_view, double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
  };
  solve(coarse_case(), linear_step_history(0.0, 0.01, {0.0, 0.1}), options);
  EXPECT_EQ(last, 1.0);
}

} // namespace
} // namespace ionskin::electrochemistry
