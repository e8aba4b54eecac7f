// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::base {

/// Piecewise-linear value of a quantity at an instant; clamped to the first and last row.
/// @param time [s], strictly ascending
double value_at(const std::vector<double>& time, const std::vector<double>& quantity,
                double instant);

} // namespace ionskin::base
