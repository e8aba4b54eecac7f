// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/cohesive_zone.hpp"

#include <algorithm>

namespace ionskin::laws {

double CohesiveZone::tension(double opening) const {
  return opening < range ? strength * (1 - std::max(0.0, opening) / range) : 0.0;
}

double CohesiveZone::binding_energy(double opening) const {
  return opening < range ? 0.5 * tension(opening) * (range - std::max(0.0, opening)) : 0.0;
}

} // namespace ionskin::laws
