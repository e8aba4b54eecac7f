// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/exact_average.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ionskin::electrochemistry {
namespace {

TEST(ExactAverage, RestoresTheAmountOfIonsAndGauss) {
  const ScaledGrid grid = test::small_grid();
  IonState state = test::wavy_state(grid);
  const IonState before = state;
  const std::vector<double> start(grid.nodes(), 1.0), fixed(grid.nodes(), 1.2);
  const double amount = ExactAverage::total(grid, start);
  ExactAverage average(grid);
  average.correct({start, 1.0, fixed, -0.5, 2.0, amount}, state);
  EXPECT_NEAR(ExactAverage::total(grid, state.concentration()), amount, 1e-13 * amount);
  WallCharges charges;
  wall_charges(grid, state, fixed, charges);
  EXPECT_NEAR(charges.total_top + charges.total_bottom, 0.2 * amount, 1e-11);
  EXPECT_EQ(state.potential().front(), -0.5);
  EXPECT_EQ(state.potential().back(), 2.0);
  // Differences between columns stay.
  const std::size_t level = 3 * grid.columns();
  EXPECT_NEAR(state.potential()[level] - state.potential()[level + 4],
              before.potential()[level] - before.potential()[level + 4], 1e-13);
}

} // namespace
} // namespace ionskin::electrochemistry
