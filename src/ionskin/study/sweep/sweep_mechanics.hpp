// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// Points (index from 0) whose Study 1 could not be solved, each with the reason.
using SweepFailures = std::map<std::size_t, std::string>;

/// Points that differ, in Study 1, only in the friction coefficient, so that they share the skin
/// and its compliance.
struct MechanicsGroup {
  /// For each friction coefficient, the indices of its points.
  std::vector<std::vector<std::size_t>> solutions;
  std::size_t first_point() const { return solutions.front().front(); }
};
/// Groups of all points with a contact, in the order of the points.
std::vector<MechanicsGroup> mechanics_groups(const std::vector<SweepPoint>& points);

/// Memory of the contact solutions of several friction coefficients that are solved at once
/// [bytes]. It is bounded, as coefficients that do not fit are solved one after another.
/// @param solutions number of friction coefficients
double solutions_memory(const Case& input, std::size_t solutions);

/// Solves Study 1 of the given points and writes it into their run folders, where `run_case` reads
/// it. Points whose Study 1 is the same share the solution; points that differ only in the friction
/// coefficient share the skin. When the solver gives up on several together, or their contact
/// leaves the skin, each is tried by itself.
/// @param unfinished indices of the points to solve; points whose run folders hold Study 1 already
/// are left out
/// @param options of one point's run; `folder` is the folder that holds all run folders
/// @param others folder with run folders of further points, from which the same Study 1 is copied
SweepFailures solve_shared_mechanics(const std::vector<SweepPoint>& points,
                                     const std::vector<std::size_t>& unfinished,
                                     const RunOptions& options, const std::filesystem::path& others,
                                     base::Timers& timers);

} // namespace ionskin::study
