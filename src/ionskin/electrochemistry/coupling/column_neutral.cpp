// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/column_neutral.hpp"

namespace ionskin::electrochemistry {

void apply_column_neutral(double coefficient, const ScaledGrid& grid, std::span<const double> shear,
                          std::span<double> ratio) {
  for (std::size_t i = 0; i < grid.columns(); ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < grid.levels; ++k) {
      mean += grid.height[k] / grid.thickness * shear[k * grid.columns() + i];
    }
    for (std::size_t k = 0; k < grid.levels; ++k) {
      const std::size_t node = k * grid.columns() + i;
      ratio[node] = 1.0 + coefficient * (shear[node] - mean);
    }
  }
}

} // namespace ionskin::electrochemistry
