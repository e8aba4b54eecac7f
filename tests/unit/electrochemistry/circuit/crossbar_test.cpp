// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/crossbar.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/case/document/taxel_grid.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/taxel_crosstalk.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace ionskin::electrochemistry {
namespace {

using verification::model_case;
using verification::slide_onset_history;

IonSolution solve_lines(const Case& input, const IonOptions& options = {}) {
  base::Timers timers;
  return solve_ion_transport(input, slide_onset_history(), options, timers);
}

/// Two rows and three columns on the skin of the model.
Case crossed(const char* columns, const char* rows, double resistance = 100.0) {
  Case input = model_case();
  input.coupling.law = "column-neutral";
  input.numerics.preset = Preset::coarse;
  input.readout.taxel_grid = {2, 3, 0, TaxelWiring::crossbar};
  input.readout.taxels = taxels_of(input.readout.taxel_grid, input.skin);
  input.readout.taxel_circuit = columns;
  input.readout.row_circuit = rows;
  input.readout.parameters = {{"load_resistance", resistance}, {"load_capacitance", 1e-6}};
  return input;
}

Case scanned_lines(const char* columns, const char* rows, bool grounds_others) {
  Case input = crossed(columns, rows);
  input.readout.scan = {0.05, grounds_others};
  return input;
}

const SegmentCharge& named(const std::vector<SegmentCharge>& segments, const std::string& name) {
  return *std::ranges::find(segments, name, &SegmentCharge::name);
}

TEST(Crossbar, GroundedLinesAreOneElectrodeCutAfterwards) {
  Case whole = crossed("shared", "short");
  whole.readout.taxel_grid.wiring = TaxelWiring::single;
  const IonSolution one = solve_lines(whole), cut = solve_lines(crossed("short", "short"));
  ASSERT_EQ(one.time, cut.time);
  const double scale = base::largest_magnitude(one.charge_top);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t row = 0; row < one.time.size(); ++row) {
      EXPECT_NEAR(one.top_segments[i].charge[row], cut.top_segments[i].charge[row], 1e-10 * scale);
    }
    EXPECT_TRUE(cut.top_segments[i].passed.empty());
  }
  const double of_column = one.top_segments[1].charge.back() + one.top_segments[4].charge.back();
  EXPECT_NEAR(named(cut.lines, "c2").passed.back(), of_column, 1e-10 * scale);
  const double of_row = one.top_segments[3].bottom_charge.back() +
                        one.top_segments[4].bottom_charge.back() +
                        one.top_segments[5].bottom_charge.back();
  EXPECT_NEAR(named(cut.lines, "r2").passed.back(), of_row, 1e-10 * scale);
}

TEST(Crossbar, ChargeIsConserved) {
  for (const Case& input :
       {crossed("load", "short"), crossed("short", "load"), scanned_lines("load", "short", false),
        scanned_lines("short", "parallel-rc", false), scanned_lines("load", "load", true)}) {
    const IonSolution cut = solve_lines(input);
    ASSERT_EQ(cut.lines.size(), 5U);
    double scale = 0;
    for (const SegmentCharge& line : cut.lines) {
      scale = std::max(scale, base::largest_magnitude(line.passed));
    }
    ASSERT_GT(scale, 0);
    for (std::size_t row = 0; row < cut.time.size(); ++row) {
      double passed = 0, of_crossings = 0;
      for (const SegmentCharge& line : cut.lines) {
        passed += line.passed[row];
      }
      EXPECT_NEAR(passed, 0, 1e-13 * scale);
      for (const SegmentCharge& crossing : cut.top_segments) {
        of_crossings += crossing.passed.empty() ? 0 : crossing.passed[row];
      }
      for (std::size_t column = 0; column < 3 && input.readout.scan.dwell > 0; ++column) {
        of_crossings -= cut.lines[column].passed[row];
      }
      EXPECT_NEAR(of_crossings, 0, 1e-13 * scale);
    }
  }
}

TEST(Crossbar, ARowThatIsNotReadPassesNothingWhileItIsOpen) {
  const IonSolution cut = solve_lines(scanned_lines("load", "short", false));
  const SegmentCharge &first = named(cut.lines, "r1"), &second = named(cut.lines, "r2");
  EXPECT_GT(base::largest_magnitude(second.voltage), 0);
  for (std::size_t row = 1; row < cut.time.size(); ++row) {
    const double middle = 0.5 * (cut.time[row - 1] + cut.time[row]);
    const bool reads_first = static_cast<std::size_t>(middle / 0.05) % 2 == 0;
    EXPECT_EQ((reads_first ? first : second).voltage[row], 0);
    const SegmentCharge& other = reads_first ? second : first;
    EXPECT_NEAR(other.passed[row], other.passed[row - 1],
                1e-12 * base::largest_magnitude(first.passed));
    const SegmentCharge& unread = cut.top_segments[reads_first ? 4 : 1];
    EXPECT_EQ(unread.passed[row], unread.passed[row - 1]);
    EXPECT_NEAR(cut.top_segments[1].voltage[row],
                named(cut.lines, "c2").voltage[row] - first.voltage[row],
                1e-14 * base::largest_magnitude(second.voltage));
  }
}

TEST(Crossbar, InterruptedAndResumedEqualsUninterrupted) {
  const Case input = scanned_lines("parallel-rc", "short", false);
  const IonSolution whole = solve_lines(input);
  struct Stop : std::exception {};
  IonCheckpoint kept;
  IonOptions first;
  first.checkpoint_interval = 20;
  first.checkpoint_seconds = 0;
  first.checkpoint = [&kept](const IonCheckpoint& checkpoint) {
    kept = checkpoint;
    throw Stop();
  };
  EXPECT_THROW(solve_lines(input, first), Stop);
  IonOptions second;
  second.resume = kept;
  second.threads = 2;
  const IonSolution resumed = solve_lines(input, second);
  EXPECT_EQ(whole.time, resumed.time);
  for (std::size_t e = 0; e < whole.lines.size(); ++e) {
    EXPECT_EQ(whole.lines[e].voltage, resumed.lines[e].voltage);
    EXPECT_EQ(whole.lines[e].passed, resumed.lines[e].passed);
  }
}

/// A net charge returns through the ground, half of it below either face.
TEST(Crossbar, NetChargeReturnsThroughTheGround) {
  Case input = crossed("load", "short");
  input.coupling.law = "fixed-charge";
  const IonSolution cut = solve_lines(input);
  double passed = 0, on_metal = 0;
  for (const SegmentCharge& line : cut.lines) {
    passed += line.passed.back();
    on_metal += line.charge.back();
  }
  EXPECT_NEAR(on_metal, cut.charge_top.back() + cut.charge_bottom.back(),
              1e-11 * std::abs(on_metal));
  EXPECT_NEAR(passed, 0, 1e-11 * std::abs(on_metal));
}

TEST(Crossbar, CrosstalkShowsWhichReadingsDistinguishCrossings) {
  const auto crosstalk = [](const Case& input) {
    return taxel_crosstalk(input, slide_onset_history()).value();
  };
  // All crossings of a grounded column show the same, whichever row is read.
  EXPECT_NEAR(crosstalk(scanned_lines("short", "short", true)), 1, 1e-9);
  EXPECT_LT(crosstalk(scanned_lines("short", "short", false)), 0.8);
  EXPECT_LT(crosstalk(crossed("short", "short")), 0.05); // of a line with the next
}

} // namespace
} // namespace ionskin::electrochemistry
