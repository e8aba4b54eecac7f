// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/percent.hpp"

#include <fmt/format.h>

#include <string>

namespace ionskin::base {

std::string percent(double share) {
  const double value = 100 * share;
  if (value > 1000) {
    return "over 1000 %";
  }
  // Rounded to two digits first: a plain format would give ten or more an exponent or more digits.
  return value < 10 ? fmt::format("{:.2g} %", value)
                    : fmt::format("{:.0f} %", std::stod(fmt::format("{:.1e}", value)));
}

} // namespace ionskin::base
