// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_points.hpp"

#include <string>

namespace ionskin::apps {

/// Line of text on the estimated cost of a sweep: number of points, number of contact solutions,
/// and wall time.
/// @param both_studies false if only the mechanics (Study 1) will be solved
/// @param threads number of threads with which the sweep will run
/// @param report_seconds wall time of the report, 0 without one [s]
std::string sweep_cost(const study::SweepPlan& plan, bool both_studies, int threads,
                       double report_seconds);

} // namespace ionskin::apps
