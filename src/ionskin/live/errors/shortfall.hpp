// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <string>

namespace ionskin::live {

/// The promise of a live skin: largest rms error of a signal over an event, of the largest value
/// of the signal within such events [1].
inline constexpr double promised_error = 0.1;

/// Largest moment that counts as 0: rounding and sweeps leave so much of one that symmetry forbids
/// [N m].
double least_moment(const SkinData& data);

/// Leaves out the errors of moments that stay below `least_moment`: there is nothing to compare.
void leave_out_no_moments(SkinData& data);

/// One line on the signals and events whose stated errors are above the promise, the worst first;
/// empty where all keep it.
std::string shortfall(const SkinData& data);

} // namespace ionskin::live
