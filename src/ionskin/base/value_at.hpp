// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::base {

/// Interpolates a quantity linearly in time; before the first and after the last sample it returns
/// their values.
/// @param time of the samples, strictly ascending [s]
/// @param quantity values at the samples, one per entry of `time`
/// @param instant at which to interpolate [s]
double value_at(const std::vector<double>& time, const std::vector<double>& quantity,
                double instant);

} // namespace ionskin::base
