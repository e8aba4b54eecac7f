// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/load.hpp"

#include <fmt/core.h>

namespace ionskin::circuits {

std::string Load::words() const {
  return fmt::format("resistor of {:.8g} ohm", resistance);
}

} // namespace ionskin::circuits
