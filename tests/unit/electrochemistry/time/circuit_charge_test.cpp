// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/circuit_charge.hpp"

#include "ionskin/electrochemistry/time/tr_bdf2.hpp"
#include "resting_core.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

class CircuitCharges : public testing::Test, protected test::RestingCore {
protected:
  /// Charge that a voltage of 1 puts on the electrodes and on the capacitor.
  double capacitance() const { return 1.0 / grid.thickness + circuit.capacitance; }
  void settle_at(double voltage) {
    charge.settle({polarised(voltage), std::vector<double>(2 * grid.nodes(), 0.0)});
  }

  const ScaledAdmittance circuit{0.3, 0.2};
  CircuitCharge charge{grid, fixed_charge, circuit};
};

TEST_F(CircuitCharges, AreOnTheElectrodesAndOnTheCapacitor) {
  settle_at(2.0);
  charge.begin_step(0.0);
  StageProblem problem{.step = 0.1};
  charge.add_equations(problem);
  ASSERT_TRUE(problem.circuit);
  EXPECT_NEAR(problem.circuit->start, 2.0 * capacitance(), 1e-12);
  EXPECT_DOUBLE_EQ(problem.circuit->conductance, 0.1 * 0.3 + 0.2);
}

/// Under a constant voltage the last stage has w + w of the current of a whole step behind it, and
/// its own share before it.
TEST_F(CircuitCharges, FlowThroughTheResistor) {
  settle_at(2.0);
  constexpr double duration = 0.5, current = 0.3 * 2.0;
  charge.begin_step(duration);
  charge.reach_middle(polarised(2.0));
  StageProblem problem{.step = tr_bdf2::diagonal * duration};
  charge.add_equations(problem);
  EXPECT_NEAR(problem.circuit->start,
              2.0 * capacitance() - duration * (1.0 - tr_bdf2::diagonal) * current, 1e-12);
}

/// The capacitor's share of the charge follows the shear, and is no part of the smooth one.
TEST_F(CircuitCharges, RelaxWithoutTheShareOfTheCapacitor) {
  settle_at(2.0);
  const std::vector<double> at_rest(grid.nodes(), 1.0);
  const TransportState state{polarised(2.0), std::vector<double>(2 * grid.nodes(), 0.0)};
  const Relaxation smooth = charge.reading(at_rest, state).relaxation;
  const double share = circuit.capacitance / capacitance();
  EXPECT_NEAR(smooth.charge, (1.0 - share) * 2.0 * capacitance(), 1e-12);
  EXPECT_NEAR(smooth.rate, -(1.0 - share) * 0.3 * 2.0, 1e-12);
}

} // namespace
} // namespace ionskin::electrochemistry
