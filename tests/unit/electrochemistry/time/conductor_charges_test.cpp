// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/conductor_charges.hpp"

#include "resting_core.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

/// A conductor behind a resistor and a capacitor on the first column, one at the ground on the
/// second.
class ConductorsAtRest : public testing::Test, protected test::RestingCore {
protected:
  TransportState at_potential(double potential, double charge) const {
    return {polarised(potential, 0.0),
            std::vector<double>(2 * grid.nodes(), 0.0),
            0.0,
            1.0,
            {},
            {charge, 0.0}};
  }

  const ScaledAdmittance circuit{0.3, 0.2};
  WallElectrodes electrodes{{{{1, 0}, circuit}, {{0, 1}, std::nullopt}}};
  parallel::WorkerTeam team{1};
  NewtonKrylov solver{grid, 1e-7, team, std::nullopt, &electrodes};
  ChargeNorm norm{grid};
  ConductorCharges charges{grid, fixed_charge, electrodes};
};

TEST_F(ConductorsAtRest, AConstantCurrentIsExactWithoutError) {
  TransportState state = at_potential(2.0, 5.0);
  constexpr double duration = 0.5;
  charges.settle(state);
  solver.prepare(state.ions, duration);
  charges.begin_step(duration);
  charges.reach_middle(state.ions);
  charges.reach_end(state.ions);
  charges.accept(state);
  EXPECT_THAT(state.electrode_charge, ElementsAre(DoubleEq(5.0 - duration * 0.3 * 2.0), 0.0));
  const std::vector<double> no_change(grid.nodes(), 0.0);
  EXPECT_NEAR(charges.step_error(no_change, 1.0, solver, norm), 0.0, 1e-15);
}

TEST_F(ConductorsAtRest, ACurrentThatChangesHasAnError) {
  const TransportState state = at_potential(2.0, 5.0);
  constexpr double duration = 0.5;
  charges.settle(state);
  solver.prepare(state.ions, duration);
  charges.begin_step(duration);
  charges.reach_middle(polarised(2.0, 0.0));
  charges.reach_end(polarised(1.0, 0.0));
  const std::vector<double> no_change(grid.nodes(), 0.0);
  EXPECT_GT(charges.step_error(no_change, 1.0, solver, norm), 0.01);
}

TEST_F(ConductorsAtRest, TheStageHoldsTheGroundedConductor) {
  charges.settle(at_potential(2.0, 5.0));
  charges.begin_step(0.0);
  StageProblem problem{.step = 0.1};
  charges.add_equations(problem);
  ASSERT_NE(problem.electrodes, nullptr);
  EXPECT_THAT(problem.electrodes->start, ElementsAre(5.0, 0.0));
  EXPECT_DOUBLE_EQ(problem.electrodes->conductance[0], 0.1 * 0.3 + 0.2);
  EXPECT_FALSE(problem.electrodes->holds(0));
  EXPECT_TRUE(problem.electrodes->holds(1));
}

TEST_F(ConductorsAtRest, AGuessIsCorrectedToTheGround) {
  IonState guess = polarised(2.0, 1e-9);
  charges.correct_guess(guess);
  EXPECT_EQ(guess.potential()[grid.nodes() - 1], 0.0);
  EXPECT_DOUBLE_EQ(guess.potential()[grid.nodes() - 2], 2.0);
}

TEST_F(ConductorsAtRest, AConductorThatComesToTheGroundGivesUpItsCapacitor) {
  TransportState state = at_potential(2.0, 5.0);
  charges.settle(state);
  charges.reconnect({std::nullopt, std::nullopt}, state);
  EXPECT_DOUBLE_EQ(state.electrode_charge[0], 5.0 - 0.2 * 2.0);
  EXPECT_EQ(state.ions.potential().back(), 0.0);
  EXPECT_EQ(state.ions.potential()[grid.nodes() - 2], 0.0);
}

} // namespace
} // namespace ionskin::electrochemistry
