// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/coupling/volume_neutral.hpp"

namespace ionskin::laws {

void VolumeNeutral::apply(const CoreLayout& core, std::span<const double> shear,
                          std::span<double> ratio) const {
  double mean = 0.0;
  for (std::size_t k = 0; k < core.levels; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < core.columns; ++i) {
      sum += shear[k * core.columns + i];
    }
    mean += core.height[k] / core.thickness * sum / static_cast<double>(core.columns);
  }
  for (std::size_t i = 0; i < shear.size(); ++i) {
    ratio[i] = 1.0 + coefficient * (shear[i] - mean);
  }
}

} // namespace ionskin::laws
