// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::history {

/// Length of each cell within [0, extent].
std::vector<double> lengths_within(const std::vector<double>& edges, double extent);

/// Makes the integral over the core's area, at every z node, linear in time between the samples.
/// Cells that ride across the ends of the skin would bend it: their values and their overlaps with
/// the core change together, and the shear falls off steeply there. The bend is of second order in
/// the distance between the samples, but its rate is a sawtooth in the current. The field changes
/// in proportion to its magnitude, so that zeros stay and signs too; by no more than a half.
/// @param field interpolated at this instant; a field of the skin's frame needs nothing
void keep_level_integrals_linear(const CoreHistory& history, const HistoryChannel& channel,
                                 const TimeBracket& at, StrainField& field);

} // namespace ionskin::history
