// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/fixed_charge.hpp"

namespace ionskin::electrochemistry {

void apply_fixed_charge(double coefficient, std::span<const double> shear,
                        std::span<double> ratio) {
  for (std::size_t i = 0; i < shear.size(); ++i) {
    ratio[i] = 1.0 + coefficient * shear[i];
  }
}

} // namespace ionskin::electrochemistry
