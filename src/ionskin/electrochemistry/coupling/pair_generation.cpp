// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/pair_generation.hpp"

#include <cstddef>

namespace ionskin::electrochemistry {

void apply_pair_generation(double coefficient, std::span<const double> shear,
                           std::span<double> ratio) {
  for (std::size_t i = 0; i < shear.size(); ++i) {
    ratio[i] = 1.0 + coefficient * shear[i];
  }
}

} // namespace ionskin::electrochemistry
