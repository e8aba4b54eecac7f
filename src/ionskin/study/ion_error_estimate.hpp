// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/ion_solution.hpp"
#include "ionskin/strain/strain_history.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Relative errors that the mesh and the time steps of Study 2 leave in its currents and voltages,
/// for a given history of shear, by name of the metric. `tail_current_difference` is the rms of the
/// error over that of the sampled current, both outside the contact spikes.
/// Each is the difference from a companion run on twice the mesh sizes and up to twice the time
/// steps, at a small part of the cost. Were both errors of order 2, the error would be a third of
/// it; where landings and sharp edges rule, it is nearer to all of it: docs/electrochemistry.md
/// compares the estimate with the truth.
/// Quantities that rounding alone makes (the common current of a neutral law) are left out.
/// Stage in `timers`: "error estimate". Throws SolverError when the companion finds no solution,
/// and Interrupted.
std::map<std::string, double> estimate_ion_errors(const Case& input,
                                                  const strain::StrainHistory& history,
                                                  const electrochemistry::IonSolution& ions,
                                                  int threads, base::Timers& timers);

} // namespace ionskin::study
