// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/signed_xz_shear.hpp"

namespace ionskin::laws {

double SignedXzShear::at(const std::array<double, 6>& strain) {
  return 2 * strain[4];
}

} // namespace ionskin::laws
