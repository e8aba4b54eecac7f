// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/percent.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace ionskin::base {

std::string percent(double share) {
  const double value = 100 * share;
  if (value > 1000) {
    return "over 1000 %";
  }
  // Values from 10 on are rounded to two digits first: a plain format would print them with an
  // exponent or with more digits.
  if (value < 10) {
    return fmt::format("{:.2g} %", value);
  }
  const std::string rounded = fmt::format("{:.1e}", value);
  double two_digits = value;
  std::from_chars(rounded.data(), rounded.data() + rounded.size(), two_digits);
  return fmt::format("{:.0f} %", two_digits);
}

} // namespace ionskin::base
