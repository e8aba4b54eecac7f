// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/taxel_crosstalk.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>

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

/// The skin of the model with `count` taxels side by side along x, all with one circuit.
Case with_taxels(int count, const char* circuit, double resistance = 1e3, double capacitance = 0) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.readout.parameters = {{"load_resistance", resistance}, {"load_capacitance", capacitance}};
  const double width = input.skin.length / count;
  for (int i = 0; i < count; ++i) {
    input.readout.taxels.push_back({std::string(1, static_cast<char>('a' + i)),
                                    {i * width, 0},
                                    {(i + 1) * width, input.skin.width}});
  }
  input.readout.taxel_circuit = circuit;
  return input;
}

Case without_taxels(const char* circuit) {
  Case input = with_taxels(1, circuit);
  input.readout.taxels.clear();
  input.readout.circuit = circuit;
  return input;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a.size());
  std::ranges::transform(a, b, difference.begin(), std::minus<>());
  return base::largest_magnitude(difference);
}

TEST(CutElectrode, GroundedTaxelsAreOneElectrodeCutAfterwards) {
  Case whole = with_taxels(4, "shared");
  const IonSolution one = solve(whole, slide_onset_history()),
                    cut = solve(with_taxels(4, "short"), slide_onset_history());
  ASSERT_EQ(one.time, cut.time);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(largest_difference(one.top_segments[i].charge, cut.top_segments[i].charge),
              1e-10 * base::largest_magnitude(one.charge_top));
    EXPECT_EQ(base::largest_magnitude(cut.top_segments[i].voltage), 0);
  }
}

/// 4 mOhm each, beside some ohms of the cell.
TEST(CutElectrode, TaxelsBehindNoLoadAreNearlyGrounded) {
  const IonSolution one = solve(with_taxels(4, "short"), slide_onset_history()),
                    cut = solve(with_taxels(4, "load", 4e-3), slide_onset_history());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(one.top_segments[i].charge.back(), cut.top_segments[i].charge.back(),
                5e-3 * base::largest_magnitude(one.charge_top));
  }
}

TEST(CutElectrode, OpenTaxelsUnderAnEvenLoadAreTheOpenCell) {
  const auto history = linear_step_history(-1e-3, 1e-3, {0.0, 1e-3, 0.01, 0.1, 1.0});
  const IonSolution one = solve(without_taxels("open"), history),
                    cut = solve(with_taxels(3, "open"), history);
  for (const double time : {1e-3, 0.01, 0.1, 1.0}) {
    const auto row = [time](const IonSolution& solution) {
      return static_cast<std::size_t>(std::ranges::find(solution.time, time) -
                                      solution.time.begin());
    };
    for (const SegmentCharge& taxel : cut.top_segments) {
      EXPECT_NEAR(taxel.voltage[row(cut)], one.voltage[row(one)],
                  1e-4 * base::largest_magnitude(one.voltage));
      EXPECT_EQ(taxel.passed[row(cut)], 0);
    }
  }
}

TEST(CutElectrode, ChargeIsConserved) {
  for (const char* circuit : {"open", "load", "parallel-rc"}) {
    Case input = with_taxels(5, circuit, 100.0, 1e-5);
    input.coupling.law = "column-neutral";
    Case grounded = input;
    grounded.readout.taxel_circuit = "short";
    const double scale =
        base::largest_magnitude(solve(grounded, slide_onset_history()).top_segments[1].charge);
    const IonSolution cut = solve(input, slide_onset_history());
    for (std::size_t row = 0; row < cut.time.size(); ++row) {
      EXPECT_NEAR(cut.charge_top[row], -cut.charge_bottom[row], 1e-10 * scale);
      EXPECT_NEAR(cut.charge_top[row], cut.ramo_charge_top[row], 1e-11 * scale);
      double sum = 0, passed = 0;
      for (const SegmentCharge& taxel : cut.top_segments) {
        sum += taxel.charge[row];
        passed += taxel.passed[row];
      }
      EXPECT_NEAR(sum, cut.charge_top[row], 1e-11 * scale);
      EXPECT_EQ(sum, passed); // of a law without net charge
    }
  }
}

/// The open electrode and the taxels of one share what the law makes.
TEST(CutElectrode, NetChargeReturnsThroughTheGround) {
  const auto history = linear_step_history(0.0, 1e-3, {0.0, 0.1});
  const IonSolution one = solve(without_taxels("open"), history),
                    cut = solve(with_taxels(2, "open"), history);
  EXPECT_NEAR(cut.charge_top.back(), one.charge_top.back(), 1e-6 * std::abs(one.charge_top.back()));
  EXPECT_GT(std::abs(one.charge_top.back()), 0);
  EXPECT_NEAR(cut.top_segments[0].charge.back(), 0.5 * one.charge_top.back(),
              1e-6 * std::abs(one.charge_top.back()));
}

TEST(CutElectrode, HalfTheSkinIsSolvedWhereTheTaxelsAreMirrored) {
  Case input = with_taxels(2, "load", 30.0);
  const double width = input.skin.width;
  // Two rows: a and b below, c and d above.
  for (std::size_t i = 0; i < 2; ++i) {
    input.readout.taxels[i].upper[1] = 0.5 * width;
    input.readout.taxels.push_back(input.readout.taxels[i]);
    input.readout.taxels.back().name = i == 0 ? "c" : "d";
    input.readout.taxels.back().lower[1] = 0.5 * width;
    input.readout.taxels.back().upper[1] = width;
  }
  EXPECT_TRUE(taxels_are_mirrored(input.readout, width));
  const IonSolution half = solve(input, slide_onset_history());
  input.readout.taxels[3].parameters["load_resistance"] = 30.0 * (1 + 1e-12);
  EXPECT_FALSE(taxels_are_mirrored(input.readout, width));
  const IonSolution whole = solve(input, slide_onset_history());
  ASSERT_EQ(half.top_segments.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(half.top_segments[i].voltage.back(), whole.top_segments[i].voltage.back(),
                1e-4 * base::largest_magnitude(whole.top_segments[0].voltage));
    EXPECT_NEAR(half.top_segments[i].passed.back(), whole.top_segments[i].passed.back(),
                1e-4 * base::largest_magnitude(whole.top_segments[0].passed));
  }
}

/// The second taxel ends inside a column, which it shares with the grounded rest.
TEST(CutElectrode, TheGroundStaysTheGround) {
  Case input = with_taxels(3, "open");
  input.readout.taxels.pop_back();
  input.readout.taxels[1].upper[0] = 9.3e-3;
  const IonSolution cut = solve(input, slide_onset_history());
  ASSERT_EQ(cut.top_segments[2].name, "rest");
  EXPECT_EQ(base::largest_magnitude(cut.top_segments[2].voltage), 0);
  EXPECT_GT(base::largest_magnitude(cut.top_segments[1].voltage), 0);
}

TEST(CutElectrode, WhatHasNoCircuitOfItsOwnIsTheElectrode) {
  Case input = with_taxels(3, "shared");
  input.readout.taxels[1].circuit = "open";
  const IonSolution cut = solve(input, slide_onset_history());
  EXPECT_EQ(base::largest_magnitude(cut.top_segments[0].voltage), 0);
  EXPECT_EQ(base::largest_magnitude(cut.top_segments[2].voltage), 0);
  EXPECT_GT(base::largest_magnitude(cut.top_segments[1].voltage), 0);
  EXPECT_TRUE(cut.top_segments[0].passed.empty());
  EXPECT_EQ(base::largest_magnitude(cut.top_segments[1].passed), 0);
}

/// A run that is stopped after some steps and resumed is the one that was not, to the bit.
void expect_resumes(const Case& input, const IonSolution& whole, std::size_t steps) {
  struct Stop : std::exception {};
  IonCheckpoint kept;
  IonOptions first;
  first.checkpoint_interval = steps;
  first.checkpoint_seconds = 0;
  first.checkpoint = [&kept](const IonCheckpoint& checkpoint) {
    kept = checkpoint;
    throw Stop();
  };
  EXPECT_THROW(solve(input, slide_onset_history(), first), Stop);
  IonOptions second;
  second.resume = kept;
  const IonSolution resumed = solve(input, slide_onset_history(), second);
  EXPECT_EQ(whole.time, resumed.time);
  for (std::size_t i = 0; i < whole.top_segments.size(); ++i) {
    EXPECT_EQ(whole.top_segments[i].voltage, resumed.top_segments[i].voltage);
    EXPECT_EQ(whole.top_segments[i].passed, resumed.top_segments[i].passed);
  }
}

TEST(CutElectrode, InterruptedAndResumedEqualsUninterrupted) {
  const Case input = with_taxels(4, "parallel-rc", 100.0, 1e-5);
  expect_resumes(input, solve(input, slide_onset_history()), 20);
}

TEST(CutElectrode, ThreadsDoNotChangeABit) {
  const Case input = with_taxels(4, "load", 100.0);
  IonOptions three;
  three.threads = 3;
  const IonSolution a = solve(input, slide_onset_history()),
                    b = solve(input, slide_onset_history(), three);
  EXPECT_EQ(a.charge_top, b.charge_top);
  EXPECT_EQ(a.top_segments[2].voltage, b.top_segments[2].voltage);
}

/// Four taxels of a list, each a row, read for 50 ms.
Case scanned(const char* circuit, bool grounds_others) {
  Case input = with_taxels(4, circuit, 100.0);
  input.readout.scan = {0.05, grounds_others};
  return input;
}

TEST(Scan, StepsEndWhereTheNextRowIsRead) {
  const IonSolution solution = solve(scanned("load", true), slide_onset_history());
  for (const double instant : {0.05, 0.1, 0.15, 0.5}) {
    EXPECT_TRUE(std::ranges::any_of(solution.time, [instant](double time) {
      return std::abs(time - instant) < 1e-12;
    })) << instant;
  }
}

TEST(Scan, ReadsChargeOfOneRowAtATime) {
  const IonSolution solution = solve(scanned("load", true), slide_onset_history());
  for (std::size_t row = 1; row < solution.time.size(); ++row) {
    const double middle = 0.5 * (solution.time[row - 1] + solution.time[row]);
    const auto read = static_cast<std::size_t>(middle / 0.05) % 4;
    for (std::size_t i = 0; i < 4; ++i) {
      const SegmentCharge& taxel = solution.top_segments[i];
      if (i != read) {
        EXPECT_EQ(taxel.passed[row], taxel.passed[row - 1]);
      } else {
        EXPECT_EQ(taxel.bypassed[row], taxel.bypassed[row - 1]);
      }
      // A taxel out of its turn is at the ground; the row of a switch is the end of its turn.
      if (i != read) {
        EXPECT_EQ(taxel.voltage[row], 0);
      }
    }
  }
  EXPECT_GT(base::largest_magnitude(solution.top_segments[1].passed), 0);
}

/// A taxel that is grounded between its turns, and in them, is never anything else.
TEST(Scan, OfGroundedTaxelsChangesNothing) {
  const IonSolution plain = solve(with_taxels(4, "short"), slide_onset_history()),
                    read = solve(scanned("short", true), slide_onset_history());
  for (std::size_t i = 0; i < 4; ++i) {
    const SegmentCharge &one = plain.top_segments[i], &other = read.top_segments[i];
    EXPECT_NEAR(one.charge.back(), other.charge.back(),
                1e-3 * base::largest_magnitude(plain.charge_top));
    EXPECT_NEAR(other.passed.back() + other.bypassed.back(), one.passed.back(),
                1e-3 * base::largest_magnitude(plain.charge_top));
  }
}

/// A taxel that was open keeps its charge until its turn, and gives it up at once.
TEST(Scan, OpenTaxelsDischargeInTheirTurn) {
  const auto history = linear_step_history(-1e-3, 1e-3, {0.0, 0.1, 0.2, 0.4});
  Case input = with_taxels(4, "short");
  input.readout.scan = {0.1, false};
  const IonSolution solution = solve(input, history);
  for (std::size_t i = 0; i < 4; ++i) {
    const SegmentCharge& taxel = solution.top_segments[i];
    for (std::size_t row = 1; row < solution.time.size(); ++row) {
      const auto read =
          static_cast<std::size_t>(0.5 * (solution.time[row - 1] + solution.time[row]) / 0.1);
      EXPECT_NEAR(taxel.bypassed[row], 0.0, 1e-12 * base::largest_magnitude(taxel.charge));
      if (read < i) {
        EXPECT_EQ(taxel.passed[row], 0);
        EXPECT_NE(taxel.voltage[row], 0);
      }
    }
  }
}

TEST(Scan, InterruptedAndResumedEqualsUninterrupted) {
  const Case input = scanned("parallel-rc", false);
  const IonSolution whole = solve(input, slide_onset_history());
  for (const std::size_t steps : {20U, 33U}) {
    expect_resumes(input, whole, steps);
  }
}

TEST(TaxelCrosstalk, FallsWithTheDistanceAndIsNoneOfOneConductor) {
  const auto history = slide_onset_history();
  EXPECT_FALSE(taxel_crosstalk(with_taxels(4, "shared"), history));
  const double near = taxel_crosstalk(with_taxels(20, "open"), history).value();
  const double far = taxel_crosstalk(with_taxels(2, "open"), history).value();
  EXPECT_GT(near, 2 * far);
  EXPECT_LT(near, 1);
  EXPECT_GT(far, 0);
}

} // namespace
} // namespace ionskin::electrochemistry
