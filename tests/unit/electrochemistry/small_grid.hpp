// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <cmath>

namespace ionskin::electrochemistry::test {

/// 5 x 3 columns of 12 to 20 Debye lengths, 9 uneven levels.
inline ScaledGrid small_grid() {
  return scale_grid(
      {{0, 20, 40, 60, 80, 100}, {0, 12, 24, 36}, {0, 0.5, 1.2, 2.1, 4.0, 6.0, 7.5, 8.6, 9.0}},
      1.0);
}

/// A smooth state without symmetry; concentrations between 0.5 and 1.5.
inline IonState wavy_state(const ScaledGrid& grid) {
  IonState state(grid.nodes());
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    const auto x = static_cast<double>(i);
    state.concentration()[i] = 1.0 + 0.4 * std::sin(0.7 * x) + 0.1 * std::cos(0.13 * x);
    state.potential()[i] = 1.5 * std::cos(0.4 * x) - 0.8 * std::sin(0.11 * x);
  }
  return state;
}

} // namespace ionskin::electrochemistry::test
