// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/energy_balance.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace ionskin::handover {
namespace {

/// A state of one cell.
mechanics::SharedState one_cell(double pressure, double traction, double stored) {
  mechanics::ContactState state;
  state.normal_traction = {pressure};
  state.tangential_traction_x = {traction};
  state.tangential_traction_y = {0};
  state.indentation = 1e-6;
  state.surface = {0, 0, 0};
  state.friction_energy = stored;
  return std::make_shared<const mechanics::ContactState>(state);
}

/// Slides by 6 mm from rest to an end at which friction still stores a hundredth of the work.
mechanics::ContactSolution slide(const Case& input) {
  mechanics::ContactSolution contact{mesh::SkinMesh(input)};
  contact.cell_lines_x = contact.cell_lines_y = {0, 1e-3};
  contact.stepped = {{0, {4.5e-3, 1e-3}, -1e-6, one_cell(1e6, 3e5, 0)},
                     {2, {10.5e-3, 1e-3}, -1e-6, one_cell(1e6, 3e5, 18e-6)}};
  return contact;
}

TEST(EnergyBalance, CountsWhatFrictionStores) {
  const Case input = small_case();
  const mechanics::ContactSolution contact = slide(input);
  const double halves = contact.mesh.half_model() ? 2 : 1;
  const EnergyBalance balance = energy_balance(ContactTimeline(input, contact), contact);
  EXPECT_NEAR(balance.external_work, halves * 0.3 * 6e-3, 1e-12);
  EXPECT_NEAR(balance.friction_work, balance.external_work - 18e-6, 1e-12);
  EXPECT_NEAR(balance.elastic_energy, 18e-6, 1e-12);
  EXPECT_NEAR(balance.relative_error, 0, 1e-12);
  EXPECT_EQ(balance.creation_error, 0);
}

TEST(EnergyBalance, ComparesWhatFrictionCreatesWithTheWork) {
  const Case input = small_case();
  mechanics::ContactSolution contact = slide(input);
  contact.created_energy = 36e-6;
  const EnergyBalance balance = energy_balance(ContactTimeline(input, contact), contact);
  EXPECT_NEAR(balance.creation_error, 36e-6 / balance.external_work, 1e-12);
}

/// Adhesion holds the slider above the height at which it landed.
TEST(EnergyBalance, CountsTheWorkOfPullsAboveTheSkin) {
  const Case input = small_case();
  mechanics::ContactSolution contact{mesh::SkinMesh(input)};
  contact.cell_lines_x = contact.cell_lines_y = {0, 1e-3};
  const auto pulled = [](double force) {
    mechanics::ContactState state = *one_cell(-1e6 * force, 0, 0);
    state.normal_force = -force;
    return std::make_shared<const mechanics::ContactState>(state);
  };
  const std::array<double, 2> place{4.5e-3, 1e-3};
  contact.stepped = {{0, place, 4e-6, nullptr},
                     {1, place, 3e-6, pulled(0.1)},
                     {2, place, -1e-6, pulled(0.3)},
                     {3, place, 5e-6, nullptr}};
  const double halves = contact.mesh.half_model() ? 2 : 1;
  const EnergyBalance balance = energy_balance(ContactTimeline(input, contact), contact);
  EXPECT_NEAR(balance.external_work, halves * (0.9e-6 - 0.05e-6 - 0.8e-6), 1e-15);
}

} // namespace
} // namespace ionskin::handover
