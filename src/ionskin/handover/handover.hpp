// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

namespace ionskin::handover {

/// Turns Study 1 into the history of the whole run, in the slider's frame: interpolates the strain
/// at fixed mesh index, takes a scalar of it for every channel, smooths that by an L2 projection in
/// the core (its integral is conserved) and averages it over cells that ride with the slider. Takes
/// milliseconds for each instant and cannot be interrupted, so that finished mechanics is never
/// lost. Throws SolverError where a channel is not finite, so that the ion transport never sees it.
/// The channels are the shear by the case's measure and, where the coupling law of the case moves
/// water, the dilation, with twice the z nodes: its values at the walls are what drives the ions.
/// @param progress called with "strain history"
history::CoreHistory
build_strain_history(const Case& input, const mechanics::ContactSolution& contact,
                     const base::ProgressCallback& progress = base::no_progress);

/// Integral of the shear over the core straight from the points of CoreStrain [m3]; the
/// reference for what the history must conserve.
double mechanics_shear_integral(const Case& input, const mesh::SkinMesh& mesh,
                                const StateCombination& combination);

} // namespace ionskin::handover
