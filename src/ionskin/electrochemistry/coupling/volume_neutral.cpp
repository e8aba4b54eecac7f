// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/volume_neutral.hpp"

namespace ionskin::electrochemistry {

void apply_volume_neutral(double coefficient, const ScaledGrid& grid, std::span<const double> shear,
                          std::span<double> ratio) {
  double mean = 0.0;
  for (std::size_t k = 0; k < grid.levels; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < grid.columns(); ++i) {
      sum += shear[k * grid.columns() + i];
    }
    mean += grid.height[k] / grid.thickness * sum / static_cast<double>(grid.columns());
  }
  for (std::size_t i = 0; i < shear.size(); ++i) {
    ratio[i] = 1.0 + coefficient * (shear[i] - mean);
  }
}

} // namespace ionskin::electrochemistry
