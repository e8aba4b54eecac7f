// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/lateral_flux.hpp"

#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

TEST(LateralFlux, LosesNothingAndVanishesForUniformColumns) {
  const ScaledGrid grid = test::small_grid();
  const IonState state = test::wavy_state(grid);
  const std::size_t columns = grid.columns();
  LateralFlux lateral(grid);
  std::vector<double> ions(columns), field(columns);
  lateral.inflow(state.concentration().first(columns), state.potential().first(columns),
                 state.potential().first(columns), ions, field);
  EXPECT_NEAR(std::accumulate(ions.begin(), ions.end(), 0.0), 0.0, 1e-16);
  EXPECT_NEAR(std::accumulate(field.begin(), field.end(), 0.0), 0.0, 1e-16);
  const std::vector<double> uniform(columns, 0.7);
  lateral.inflow(uniform, uniform, uniform, ions, field);
  EXPECT_EQ(*std::max_element(ions.begin(), ions.end()), 0.0);
}

TEST(LateralFlux, IsTheLaplacianOfAParabolaInside) {
  const ScaledGrid grid = scale_grid({{0, 1, 2, 3, 4, 5}, {0, 1}, {0, 1}}, 1.0);
  const std::vector<double> parabola{0.0, 1.0, 4.0, 9.0, 16.0}, none(5, 0.0);
  std::vector<double> ions(5), field(5);
  LateralFlux(grid).inflow(parabola, none, none, ions, field);
  EXPECT_DOUBLE_EQ(ions[2], 2.0);
  EXPECT_DOUBLE_EQ(field[2], 0.0);
}

TEST(LateralFlux, ChangeAgreesWithDifferences) {
  const ScaledGrid grid = test::small_grid();
  const IonState state = test::wavy_state(grid);
  const std::size_t columns = grid.columns();
  const auto c = state.concentration(), phi = state.potential();
  const auto dc = c.subspan(columns, columns), dphi = phi.subspan(columns, columns);
  LateralFlux lateral(grid);
  std::vector<double> change(columns), field_change(columns), c2(columns), phi2(columns);
  lateral.inflow_change(c.first(columns), phi.first(columns), dc, dphi, dphi, change, field_change);
  const double step = 1e-6;
  std::vector<double> plus(columns), minus(columns), unused(columns);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < columns; ++i) {
      c2[i] = c[i] + sign * step * dc[i];
      phi2[i] = phi[i] + sign * step * dphi[i];
    }
    lateral.inflow(c2, phi2, phi2, sign > 0 ? plus : minus, unused);
  }
  for (std::size_t i = 0; i < columns; ++i) {
    EXPECT_NEAR(change[i], (plus[i] - minus[i]) / (2.0 * step), 1e-9);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
