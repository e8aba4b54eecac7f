// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <vector>

namespace ionskin::handover {

/// Turns Study 1 of several sliders on one skin into the history of the whole run, in the skin's
/// frame: adds up the strains of all sliders at the points of the mesh of each of them, takes a
/// scalar of the sum for every channel, and averages it over cells that do not move, of which each
/// is given to the slider that is nearest to it. Samples follow one another before a slider is a
/// cell farther.
/// @param sliders one case each, of one skin, with cycles that last equally long
/// @param contacts one solution each, all of the whole skin or all of half of it
/// @param progress called with "strain history"
/// Throws SolverError where a channel is not finite.
history::CoreHistory
build_sliders_history(const std::vector<Case>& sliders,
                      const std::vector<mechanics::ContactSolution>& contacts,
                      const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::handover
