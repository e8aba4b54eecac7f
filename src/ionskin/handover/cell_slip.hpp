// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Length of the way that the slider slipped over the skin at each cell since the cell touches, at
/// instants of one cycle; 0 where it does not touch [m]. Cells ride with the slider.
/// @param instants within the cycle [s], of any order
std::vector<std::vector<double>> slip_since_landing(const ContactTimeline& timeline,
                                                    const mechanics::ContactSolution& contact,
                                                    const std::vector<double>& instants);

} // namespace ionskin::handover
