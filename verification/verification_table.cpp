// SPDX-License-Identifier: Apache-2.0
#include "verification_table.hpp"

#include <cmath>
#include <utility>

namespace ionskin::verification {

Row compare(std::string id, std::string quantity, double value, double reference,
            double tolerance) {
  const bool passed = std::abs(value - reference) <= tolerance;
  return {std::move(id), std::move(quantity), value, reference, tolerance, passed};
}

Row at_most(std::string id, std::string quantity, double value, double bound) {
  return {std::move(id), std::move(quantity), value, 0.0, bound, value <= bound};
}

Row at_least(std::string id, std::string quantity, double value, double bound) {
  return {std::move(id), std::move(quantity), value, bound, 0.0, value >= bound};
}

} // namespace ionskin::verification
