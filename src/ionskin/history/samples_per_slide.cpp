// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/samples_per_slide.hpp"

namespace ionskin::history {

double samples_per_slide(const Numerics& numerics) {
  double samples = 40;
  if (numerics.preset == Preset::coarse) {
    samples = 20;
  } else if (numerics.preset == Preset::fine) {
    samples = 80;
  }
  return samples * numerics.time_refinement;
}

} // namespace ionskin::history
