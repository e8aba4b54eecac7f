// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_points.hpp"

#include <string>

namespace ionskin::apps {

/// One line on what a sweep will cost: its points, how often the contact is solved for them, and
/// the wall time, estimated.
/// @param both_studies false for the mechanics alone
/// @param threads that will run
std::string sweep_cost(const study::SweepPlan& plan, bool both_studies, int threads,
                       double report_seconds);

} // namespace ionskin::apps
