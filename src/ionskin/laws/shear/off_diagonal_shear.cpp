// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/off_diagonal_shear.hpp"

#include <cmath>

namespace ionskin::laws {

double OffDiagonalShear::at(const std::array<double, 6>& strain) {
  return 2 * std::sqrt(strain[3] * strain[3] + strain[4] * strain[4] + strain[5] * strain[5]);
}

} // namespace ionskin::laws
