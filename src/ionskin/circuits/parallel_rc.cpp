// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/parallel_rc.hpp"

#include <fmt/core.h>

namespace ionskin::circuits {

std::string ParallelRc::words() const {
  return fmt::format("resistor of {:.8g} ohm and capacitor of {:.4g} F in parallel", resistance,
                     capacitance);
}

} // namespace ionskin::circuits
