// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/measures/compressive_dilation.hpp"

#include <cstddef>

namespace ionskin::handover {

std::vector<double> compressive_dilation(const std::array<std::vector<double>, 6>& strain) {
  std::vector<double> dilation(strain[0].size());
  for (std::size_t i = 0; i < dilation.size(); ++i) {
    dilation[i] = -(strain[0][i] + strain[1][i] + strain[2][i]);
  }
  return dilation;
}

} // namespace ionskin::handover
