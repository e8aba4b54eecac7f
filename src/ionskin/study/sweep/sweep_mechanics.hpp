// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// Point numbers (from 0) whose Study 1 could not be solved, each with the reason.
using SweepFailures = std::map<std::size_t, std::string>;

/// Points that differ in the friction coefficient only and share all factorisations.
struct MechanicsGroup {
  std::size_t first_point = 0;
  std::size_t solutions = 0; ///< different friction coefficients
};
/// The groups of all points whose Study 1 is to be solved, in the order of the points.
std::vector<MechanicsGroup> mechanics_groups(const std::vector<SweepPoint>& points);

/// Solves Study 1 of the given points and leaves it in their folders, where `run_case` takes it up.
/// Points that differ in the friction coefficient only share all factorisations; points whose Study
/// 1 is the same share it. When the solver gives up on several together, or their contact does not
/// stay on the skin, each of them is tried alone.
/// @param unfinished indices of the points to solve; those whose folders hold it already are left
/// @param options of one point's run; `folder` is that of all points
SweepFailures solve_shared_mechanics(const std::vector<SweepPoint>& points,
                                     const std::vector<std::size_t>& unfinished,
                                     const RunOptions& options, base::Timers& timers);

} // namespace ionskin::study
