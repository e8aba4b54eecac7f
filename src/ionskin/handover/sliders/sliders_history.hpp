// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <vector>

namespace ionskin::handover {

/// Transfers the strain of several sliders on one skin from Study 1 (mechanics) to Study 2 (ion
/// transport): makes the strain history of the whole run, in the frame of the skin. At the mesh
/// points of each slider it adds the strains of all sliders, takes a scalar of the sum for each
/// channel, and averages it over cells at rest. Each cell takes the field of the nearest slider.
/// Samples are so dense that no slider in contact moves by more than a cell between them.
/// @param sliders one case per slider, all with the same skin and the same duration of a cycle
/// @param contacts one solution per slider, all for the whole skin or all for half of it
/// @param progress called with "strain history"
/// Throws SolverError when a channel is not finite.
history::CoreHistory
build_sliders_history(const std::vector<Case>& sliders,
                      const std::vector<mechanics::ContactSolution>& contacts,
                      const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::handover
