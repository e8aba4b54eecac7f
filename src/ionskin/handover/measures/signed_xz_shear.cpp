// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/measures/signed_xz_shear.hpp"

namespace ionskin::handover {

double signed_xz_shear(const std::array<double, 6>& strain) {
  return 2 * strain[4];
}

} // namespace ionskin::handover
