// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/value_at.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::base {

double value_at(const std::vector<double>& time, const std::vector<double>& quantity,
                double instant) {
  const auto after = std::upper_bound(time.begin(), time.end(), instant);
  if (after == time.begin()) {
    return quantity.front();
  }
  if (after == time.end()) {
    return quantity.back();
  }
  const auto i = static_cast<std::size_t>(after - time.begin());
  const double weight = (instant - time[i - 1]) / (time[i] - time[i - 1]);
  // At the exact time of a sample, a NaN in the next sample must not spoil the value.
  return weight == 0 ? quantity[i - 1] : quantity[i - 1] + weight * (quantity[i] - quantity[i - 1]);
}

} // namespace ionskin::base
