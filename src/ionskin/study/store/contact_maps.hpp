// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/results/contact_map.hpp"

#include <vector>

namespace ionskin::study {

/// Names the states of a cycle that are kept and collects their maps, each state once.
results::ContactMaps make_contact_maps(const std::vector<MotionLeg>& legs,
                                       const mechanics::ContactSolution& contact,
                                       const handover::ContactTimeline& timeline);

} // namespace ionskin::study
