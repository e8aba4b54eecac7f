// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/preconditioner.hpp"

#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

TEST(FastDiagonalisation, DampedSumsAreThoseOfTheAnswer) {
  const ScaledGrid grid = test::small_grid();
  const IonState state = test::wavy_state(grid);
  const std::size_t nodes = grid.nodes(), columns = grid.columns();
  std::vector<double> residual(2 * nodes, 0.0), answer(2 * nodes);
  std::array<std::vector<double>, 2> weights;
  for (std::size_t i = 0; i < nodes; ++i) {
    residual[i] = grid.height[i / columns] * state.concentration()[i];
  }
  for (std::size_t k = 0; k < grid.levels; ++k) {
    weights[0].push_back(grid.position[k]);
    weights[1].push_back(1.0 - 0.2 * grid.position[k]);
  }
  for (const int threads : {1, 3}) {
    parallel::WorkerTeam team(threads);
    FastDiagonalisation inverse(grid, team);
    inverse.factorise(state, 0.3);
    inverse.apply(residual, answer);
    const auto sums = inverse.damped_sums(state.concentration(), weights);
    for (std::size_t w = 0; w < 2; ++w) {
      for (std::size_t i = 0; i < columns; ++i) {
        double expected = 0.0;
        for (std::size_t k = 0; k < grid.levels; ++k) {
          expected += weights[w][k] * answer[k * columns + i];
        }
        EXPECT_NEAR(sums[w][i], expected, 1e-5) << "weights " << w << ", column " << i;
      }
    }
  }
}

} // namespace
} // namespace ionskin::electrochemistry
