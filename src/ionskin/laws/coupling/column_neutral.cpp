// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/coupling/column_neutral.hpp"

namespace ionskin::laws {

void ColumnNeutral::apply(const CoreLayout& core, std::span<const double> shear,
                          std::span<double> ratio) const {
  for (std::size_t i = 0; i < core.columns; ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < core.levels; ++k) {
      mean += core.height[k] / core.thickness * shear[k * core.columns + i];
    }
    for (std::size_t k = 0; k < core.levels; ++k) {
      const std::size_t node = k * core.columns + i;
      ratio[node] = 1.0 + coefficient * (shear[node] - mean);
    }
  }
}

} // namespace ionskin::laws
