// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <string>

namespace ionskin::live {

/// Promised accuracy of a reduced-order skin: largest rms error of a signal over an event of the
/// touches, relative to the largest value of the signal within such events [1].
inline constexpr double promised_error = 0.1;

/// Moment below which a moment signal counts as 0 [N m]: where symmetry makes a moment vanish,
/// rounding and the contact's residual may leave as much.
double least_moment(const SkinData& data);

/// Removes from the model the errors of moments that stay below `least_moment` in all touches,
/// since an error relative to a signal of 0 says nothing.
void leave_out_no_moments(SkinData& data);

/// One line that lists the signals and events whose reported errors exceed `promised_error`,
/// largest first; empty if there is none.
std::string shortfall(const SkinData& data);

} // namespace ionskin::live
