// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::electrochemistry {

/// Solves Study 2 of a coupling law that moves water, in the limit of thin double layers and a
/// small drive, docs/model.md (34), (35). Each double layer is a capacitor eps/lambda per area, the
/// core between them a conductor sigma, and the drive of the cations an electromotive force -Omega,
/// Omega = V_T g/v. Along the skin the charges of top and bottom are cosine waves, each of which
/// decays exponentially: with alpha the wave number their sum and difference relax at
///   (sigma lambda/eps) alpha tanh(alpha h/2)   and   (sigma lambda/eps) alpha coth(alpha h/2),
/// the mean difference at 1/tau_c behind the circuit between the electrodes. The solution is exact
/// for Omega linear in time over half a step; steps are as long as the tolerance of the case
/// allows. The error of the limit is of the order of 2 lambda/h (`thin_layer_error`) and of g.
///
/// The rows are those of `solve_ion_transport`; concentrations and potentials are the extremes
/// within the layers to first order. Of `options` only `progress` is used: there are no snapshots
/// and no checkpoints. Throws Interrupted, and SolverError when no step is short enough or the
/// steps make no progress.
IonSolution solve_thin_layers(const Case& input, const history::CoreHistory& history,
                              const IonOptions& options);

/// Estimates the relative error of a charge in the limit of thin double layers, 2 lambda/h [1].
/// @param core_thickness h [m]
double thin_layer_error(const Electrochemistry& electrochemistry, double core_thickness);

} // namespace ionskin::electrochemistry
