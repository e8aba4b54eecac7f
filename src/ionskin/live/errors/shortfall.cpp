// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/errors/shortfall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace ionskin::live {
namespace {

constexpr std::size_t most_named_errors = 4; // in a line

double relative_rms(const SignalError& error) {
  return error.rms / error.largest;
}

} // namespace

std::string shortfall(const SkinData& data) {
  std::vector<SignalError> worse;
  for (const SignalError& error : data.errors) {
    if (!error.event.empty() && error.largest > 0 && relative_rms(error) > promised_error) {
      worse.push_back(error);
    }
  }
  if (worse.empty()) {
    return {};
  }
  std::ranges::stable_sort(worse, std::ranges::greater{}, relative_rms);
  std::string line;
  for (std::size_t i = 0; i < std::min(worse.size(), most_named_errors); ++i) {
    line += fmt::format("{}{} in {} {:.0f} %", i == 0 ? "" : ", ", worse[i].name, worse[i].event,
                        100 * relative_rms(worse[i]));
  }
  if (worse.size() > most_named_errors) {
    line += fmt::format(", and {} more", worse.size() - most_named_errors);
  }
  return fmt::format("rms errors above the promised {:.0f} % of the largest value within an event: "
                     "{}",
                     100 * promised_error, line);
}

} // namespace ionskin::live
