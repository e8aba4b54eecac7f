// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/sheet_charges.hpp"

#include "ionskin/electrochemistry/time/tr_bdf2.hpp"
#include "resting_core.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// Two columns of metal with leads at their outer ends.
class Sheets : public testing::Test, protected test::RestingCore {
protected:
  SheetElectrodes metal{grid, {3.0, 5.0}, {{0, 1}, {0}, {1}}, ScaledAdmittance{0.3, 0.2}};
  SheetCharges charges{grid, fixed_charge, metal};
};

TEST_F(Sheets, APackedStateComesBack) {
  SheetState state(2);
  state.charge = {std::vector{1.0, 2.0}, std::vector{3.0, 4.0}};
  state.rate = {std::vector{5.0, 6.0}, std::vector{7.0, 8.0}};
  state.passed = 9.0;
  state.passed_rate = 10.0;
  state.voltage = 11.0;
  const std::vector<double> packed = state.packed();
  EXPECT_EQ(packed.size(), charges.size());
  EXPECT_EQ(SheetState::unpacked(packed).packed(), packed);
}

TEST_F(Sheets, BringWhatTheWallsHoldAtTheEnd) {
  charges.start_run();
  charges.begin_step(0.5);
  StageProblem problem{.step = tr_bdf2::diagonal * 0.5};
  charges.add_equations(problem);
  ASSERT_NE(problem.sheets, nullptr);
  EXPECT_THAT(problem.sheets->start[top_wall], ElementsAre(0.0, 0.0));
  TransportState state{polarised(2.0, 1.0), {}};
  charges.reach_end(state.ions);
  charges.accept(state);
  const SheetState end = SheetState::unpacked(state.electrode_charge);
  const double first = 2.0 / grid.thickness, second = 1.0 / grid.thickness;
  // Field that passes sideways between the columns counts a little, too.
  EXPECT_THAT(end.charge[top_wall],
              ElementsAre(DoubleNear(first, 1e-2 * first), DoubleNear(second, 1e-2 * second)));
  EXPECT_DOUBLE_EQ(end.rate[top_wall][0], end.charge[top_wall][0] / problem.step);
  charges.settle(state);
  const ElectrodeReading reading = charges.reading({}, state);
  EXPECT_EQ(reading.lead_voltage, end.voltage);
  EXPECT_NEAR(reading.relaxation.charge, 0.5 * (first + second), 1e-2 * first);
}

} // namespace
} // namespace ionskin::electrochemistry
