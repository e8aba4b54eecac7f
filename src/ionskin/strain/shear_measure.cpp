// SPDX-License-Identifier: Apache-2.0
#include "ionskin/strain/shear_measure.hpp"

#include "ionskin/base/error.hpp"

#include <cmath>

namespace ionskin::strain {

double off_diagonal_shear(const std::array<double, 6>& strain) {
  return 2 * std::sqrt(strain[3] * strain[3] + strain[4] * strain[4] + strain[5] * strain[5]);
}

std::string_view name(ShearMeasure measure) {
  switch (measure) {
  case ShearMeasure::off_diagonal:
    return "off-diagonal";
  }
  throw InternalError("unknown shear measure");
}

void evaluate_shear(ShearMeasure measure, const std::array<std::vector<double>, 6>& component,
                    std::vector<double>& shear) {
  const std::size_t points = component[0].size();
  shear.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    switch (measure) {
    case ShearMeasure::off_diagonal:
      shear[i] = off_diagonal_shear({component[0][i], component[1][i], component[2][i],
                                     component[3][i], component[4][i], component[5][i]});
      break;
    }
  }
}

} // namespace ionskin::strain
