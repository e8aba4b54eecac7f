// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/measures/off_diagonal_shear.hpp"

#include <cmath>

namespace ionskin::handover {

double off_diagonal_shear(const std::array<double, 6>& strain) {
  return 2 * std::sqrt(strain[3] * strain[3] + strain[4] * strain[4] + strain[5] * strain[5]);
}

} // namespace ionskin::handover
