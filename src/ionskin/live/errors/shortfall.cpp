// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/errors/shortfall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <vector>

namespace ionskin::live {
namespace {

constexpr std::size_t most_named_errors = 4; ///< largest number of errors that the line names
/// Moment that counts as 0, over the heaviest force times half the diagonal of the contact cells
/// [1].
constexpr double vanishing = 1e-3;

/// True for the error of a moment that stays below `least_moment`.
bool is_no_moment(const SignalError& error, const SkinData& data) {
  return error.name.starts_with("moment_") && error.largest < least_moment(data);
}

double relative_rms(const SignalError& error) {
  return error.rms / error.largest;
}

} // namespace

double least_moment(const SkinData& data) {
  const auto extent = [](const std::vector<double>& lines) { return lines.back() - lines.front(); };
  return vanishing * data.heaviest_force *
         std::hypot(extent(data.cell_lines_x), extent(data.cell_lines_y)) / 2;
}

void leave_out_no_moments(SkinData& data) {
  std::set<std::string> none;
  for (const SignalError& error : data.errors) {
    if (error.event.empty() && is_no_moment(error, data)) {
      none.insert(error.name);
    }
  }
  std::erase_if(data.errors, [&](const SignalError& error) { return none.contains(error.name); });
}

std::string shortfall(const SkinData& data) {
  std::vector<SignalError> worse;
  for (const SignalError& error : data.errors) {
    if (!error.event.empty() && error.largest > 0 && relative_rms(error) > promised_error &&
        !is_no_moment(error, data)) {
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
