// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Calculates the path length that the slider has slipped over the skin at each cell since the cell
/// came into contact, [instant][cell] [m]. The value is 0 where a cell does not touch. Cells move
/// with the slider and are numbered x fastest.
/// @param instants within one cycle [s], in any order
std::vector<std::vector<double>> slip_since_landing(const ContactTimeline& timeline,
                                                    const mechanics::ContactSolution& contact,
                                                    const std::vector<double>& instants);

} // namespace ionskin::handover
