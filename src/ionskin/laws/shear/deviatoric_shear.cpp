// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/deviatoric_shear.hpp"

#include <cmath>

namespace ionskin::laws {

double DeviatoricShear::at(const std::array<double, 6>& strain) {
  const double mean = (strain[0] + strain[1] + strain[2]) / 3;
  const double xx = strain[0] - mean, yy = strain[1] - mean, zz = strain[2] - mean;
  const double off_diagonal = strain[3] * strain[3] + strain[4] * strain[4] + strain[5] * strain[5];
  return std::sqrt(2 * (xx * xx + yy * yy + zz * zz) + 4 * off_diagonal);
}

} // namespace ionskin::laws
