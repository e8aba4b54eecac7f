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

/// Points that differ in the friction coefficient only and share the skin.
struct MechanicsGroup {
  std::vector<std::vector<std::size_t>> solutions; ///< the points of each friction coefficient
  std::size_t first_point() const { return solutions.front().front(); }
};
/// The groups of all points whose Study 1 is to be solved, in the order of the points.
std::vector<MechanicsGroup> mechanics_groups(const std::vector<SweepPoint>& points);

/// Memory of the contact solutions of so many friction coefficients that are solved at once
/// [bytes]; coefficients that do not fit are solved one after another.
double solutions_memory(const Case& input, std::size_t solutions);

/// Solves Study 1 of the given points and leaves it in their folders, where `run_case` takes it up.
/// Points that differ in the friction coefficient only share the skin; points whose Study
/// 1 is the same share it. When the solver gives up on several together, or their contact does not
/// stay on the skin, each of them is tried alone.
/// @param unfinished indices of the points to solve; those whose folders hold it already are left
/// @param options of one point's run; `folder` is that of all points
/// @param others folder of further points, whose mechanics is taken over where it is the same
SweepFailures solve_shared_mechanics(const std::vector<SweepPoint>& points,
                                     const std::vector<std::size_t>& unfinished,
                                     const RunOptions& options, const std::filesystem::path& others,
                                     base::Timers& timers);

} // namespace ionskin::study
