// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

constexpr double area = 1e-8, slip_length = 1e-6, cell_force = 0.02; // m2, m, N

/// One cell with an elastic slip of half its length, made under a tenth of the present normal
/// force.
SurfaceState wound(double tangential_force, double slip) {
  SurfaceState state;
  state.force = {cell_force, tangential_force, 0};
  state.surface = {0, 0, 0};
  state.step = {{LoadKind::force, cell_force}, {slip, 0}, 0.1, state.surface};
  state.step.elastic_before = {{{slip_length / 2, 0}, 0.3 * cell_force / area / 10}};
  return state;
}

ContactProblem one_cell() {
  ContactProblem problem;
  problem.area = {area};
  problem.friction = laws::friction("regularised", 0.3, {{"slip_length", slip_length}});
  return problem;
}

// A stiffness in proportion to the pressure, at a slip that stays.
TEST(FrictionEnergy, SeesTheEnergyThatAStiffeningLawCreates) {
  const double limit = 0.3 * cell_force, stored = 0.5 * limit * slip_length / 4;
  const FrictionEnergy energy = friction_energy(one_cell(), wound(limit / 2, 0));
  EXPECT_NEAR(energy.stored, stored, 1e-9 * stored);
  EXPECT_NEAR(energy.created, 0.9 * stored, 1e-9 * stored);
}

TEST(FrictionEnergy, OfATractionThatStaysIsNotCreated) {
  const double limit = 0.3 * cell_force, stored = 0.5 * limit * slip_length / 4;
  const FrictionEnergy energy = friction_energy(one_cell(), wound(limit / 20, 0));
  EXPECT_NEAR(energy.stored, stored / 100, 1e-9 * stored);
  EXPECT_EQ(energy.created, 0);
}

TEST(FrictionEnergy, SeesATractionAgainstTheSlip) {
  ContactProblem problem = one_cell();
  problem.friction = laws::friction("coulomb", 0.3, {});
  const FrictionEnergy energy = friction_energy(problem, wound(-0.006, 2e-6));
  EXPECT_EQ(energy.stored, 0);
  EXPECT_NEAR(energy.created, 1.2e-8, 1e-16);
}

} // namespace
} // namespace ionskin::mechanics
