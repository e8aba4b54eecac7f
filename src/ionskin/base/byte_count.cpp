// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/byte_count.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>
#include <utility>

namespace ionskin::base {

std::uintmax_t byte_count(const std::string& name, const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double amount = -1;
  std::string unit, rest;
  stream >> amount >> unit;
  constexpr std::array<std::pair<const char*, double>, 4> units{
      {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}}};
  const auto known = std::find_if(units.begin(), units.end(),
                                  [&](const auto& candidate) { return unit == candidate.first; });
  if (!(amount >= 0) || known == units.end() || amount * known->second > 1e18 || stream >> rest) {
    throw UserError(
        fmt::format("{} = \"{}\" is not a size: give a number and kB, MB, GB or TB, such "
                    "as \"5 GB\"",
                    name, shown(text)));
  }
  return static_cast<std::uintmax_t>(amount * known->second);
}

std::string byte_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes * 1e-6)
                     : fmt::format("{:.1f} GB", bytes * 1e-9);
}

} // namespace ionskin::base
