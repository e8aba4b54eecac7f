// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::electrochemistry {

/// Study 2 of a law that moves water in the limit of thin double layers and a small drive: each
/// layer is a capacitor eps/lambda per area, the core between them a conductor sigma, and what
/// drives the cations an electromotive force -Omega, Omega = V_T g/v: docs/model.md (34), (35).
/// Along the skin the charges of top and bottom are cosine waves, of which each is an exponential
/// of its own: with alpha the wave number and a = h/2 their sum and difference relax at
///   (sigma lambda/eps) alpha tanh(alpha a)   and   (sigma lambda/eps) alpha coth(alpha a),
/// the mean difference at 1/tau_c behind the circuit between the electrodes. Exact for Omega linear
/// in time over half a step; steps are as long as the tolerance of the case allows. What it leaves
/// out is of the order of 2 lambda/h (`thin_layer_error`) and of g.
///
/// The rows are those of `solve_ion_transport`; concentrations and potentials are the extremes
/// within the layers to first order. No fields are kept. Throws Interrupted, and SolverError when
/// no step is short enough.
IonSolution solve_thin_layers(const Case& input, const history::CoreHistory& history,
                              const IonOptions& options);

/// Relative error that thin layers leave in a charge, 2 lambda/h.
double thin_layer_error(const Electrochemistry& electrochemistry, double core_thickness);

} // namespace ionskin::electrochemistry
