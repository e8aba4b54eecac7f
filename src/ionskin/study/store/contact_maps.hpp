// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/results/contact_map.hpp"

#include <vector>

namespace ionskin::study {

/// Makes named maps of traction, slip and stick over the contact cells for the stored contact
/// states of one cycle, each state once; of more than 100 instants, only some of the later ones.
/// @param legs of the motion, after which the maps are named, such as "touchdown_03"
results::ContactMaps make_contact_maps(const std::vector<MotionLeg>& legs,
                                       const mechanics::ContactSolution& contact,
                                       const handover::ContactTimeline& timeline);

} // namespace ionskin::study
