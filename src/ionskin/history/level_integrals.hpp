// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::history {

/// Length of the part of each cell that lies within [0, extent] [m].
/// @param edges of the cells [m]
std::vector<double> lengths_within(const std::vector<double>& edges, double extent);

/// Corrects an interpolated field so that its integral over the core's area is linear in time
/// between samples, at every z node. Without this, cells that move across the ends of the skin
/// would bend the integral: their values and their overlaps with the core change together, and the
/// shear falls off steeply there. The bend is of second order in the distance between samples, but
/// its rate is a sawtooth in the current. Values change in proportion to their magnitude, by at
/// most a half, so that zeros and signs stay.
/// @param field field of the channel interpolated at `at`, [z][y][x]; corrected in place. A field
///   in the skin's frame is left as it is, since its integrals are linear already
void keep_level_integrals_linear(const CoreHistory& history, const HistoryChannel& channel,
                                 const TimeBracket& at, StrainField& field);

} // namespace ionskin::history
