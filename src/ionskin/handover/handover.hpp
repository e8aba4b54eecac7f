// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

namespace ionskin::handover {

/// Transfers the strain from Study 1 (mechanics) to Study 2 (ion transport): makes the strain
/// history of the whole run, in the frame of the slider. At each sample it interpolates the strain
/// at the same mesh index, takes a scalar of the strain for each channel, smooths this scalar in
/// the core by an L2 projection, which conserves its integral, and averages it over cells that move
/// with the slider. The channels are the shear by the measure of the case and, if the coupling law
/// of the case includes water transport, the dilation. With dilation there are twice as many z
/// nodes, as its values at the walls drive the ions. The function takes milliseconds per instant
/// and cannot be interrupted, so that finished mechanics is never lost.
/// @param progress called with "strain history"
/// Throws SolverError when a channel is not finite, so that the ion transport never sees it.
history::CoreHistory
build_strain_history(const Case& input, const mechanics::ContactSolution& contact,
                     const base::ProgressCallback& progress = base::no_progress);

/// Integrates the shear over the core directly from the points of `mechanics::CoreStrain` [m3]. It
/// is the reference for the integral that the strain history must conserve.
double mechanics_shear_integral(const Case& input, const mesh::SkinMesh& mesh,
                                const StateCombination& combination);

} // namespace ionskin::handover
