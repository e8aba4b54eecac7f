// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/charges.hpp"

#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ionskin::electrochemistry {
namespace {

TEST(Charges, PlateCapacitorWithoutIons) {
  const ScaledGrid grid = test::small_grid();
  IonState state(grid.nodes());
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    state.potential()[i] = 2.0 * grid.position[i / grid.columns()];
  }
  const std::vector<double> none(grid.nodes(), 0.0);
  WallCharges charges;
  wall_charges(grid, state, none, charges);
  const double expected = 2.0 / grid.thickness;
  for (std::size_t i = 0; i < grid.columns(); ++i) {
    EXPECT_NEAR(charges.top[i], expected, 1e-14);
    EXPECT_NEAR(charges.bottom[i], -expected, 1e-14);
  }
  EXPECT_NEAR(ramo_charge_top(grid, state, none), expected * static_cast<double>(grid.columns()),
              1e-13);
}

} // namespace
} // namespace ionskin::electrochemistry
