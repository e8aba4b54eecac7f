// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"

#include "ionskin/electrochemistry/equations/lateral_flux.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ionskin::electrochemistry {
namespace {

ScaledGrid grid_of(std::size_t columns_x, std::size_t columns_y) {
  TransportGrid grid{{}, {}, {0, 1, 2}};
  for (std::size_t i = 0; i <= columns_x; ++i) {
    grid.x_edges.push_back(static_cast<double>(i));
  }
  for (std::size_t j = 0; j <= columns_y; ++j) {
    grid.y_edges.push_back(2.0 * static_cast<double>(j));
  }
  return scale_grid(grid, 1.0);
}

TEST(CosineTransform, IsInvertibleForEvenOddAndSingleColumns) {
  for (const auto& [nx, ny] :
       {std::pair<std::size_t, std::size_t>{6, 4}, {7, 3}, {1, 5}, {4, 1}, {1, 1}}) {
    const ScaledGrid grid = grid_of(nx, ny);
    const IonState state = test::wavy_state(grid);
    const CosineTransform transform(grid);
    std::vector<float> modes(grid.nodes()), scratch(grid.nodes());
    std::vector<double> back(grid.nodes());
    transform.forward(state.concentration(), modes, scratch);
    transform.backward(modes, back, scratch);
    for (std::size_t i = 0; i < grid.nodes(); ++i) {
      EXPECT_NEAR(back[i], state.concentration()[i], 2e-6);
    }
  }
}

TEST(CosineTransform, DiagonalisesTheLateralLaplacian) {
  const ScaledGrid grid = grid_of(7, 4);
  const IonState state = test::wavy_state(grid);
  const CosineTransform transform(grid);
  const std::size_t columns = grid.columns();
  const std::vector<double> none(columns, 0.0);
  const std::span<const double> level = state.concentration().first(columns);
  std::vector<double> laplacian(columns), field(columns);
  LateralFlux lateral(grid);
  lateral.inflow(level, none, none, laplacian, field);
  std::vector<float> modes(columns), modes_of_laplacian(columns), scratch(columns);
  transform.forward(level, modes, scratch);
  transform.forward(laplacian, modes_of_laplacian, scratch);
  for (std::size_t m = 0; m < columns; ++m) {
    EXPECT_NEAR(modes_of_laplacian[m], -transform.eigenvalues()[m] * modes[m], 1e-5);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
