// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/errors/error_parts.hpp"
#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/store/fit_data.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Estimates the numerical errors of a run of both studies, by metric and signal, from coarser
/// solutions. For Study 1, the strain histories of its coarser solutions, and the history of the
/// run on wider cells, are run through Study 2 with twice the mesh sizes and up to twice the time
/// steps, and compared with the run's own history there. Two more runs give the errors of that grid
/// and of those time steps. docs/errors-of-results.md says how the differences become errors. For a
/// given strain, errors of Study 1 are missing; if a contact has no coarser solutions, nothing is
/// estimated. Stage in `timers`: "error estimate".
/// @param signals of the run
/// @param progress receives the activity "error estimate"
/// Throws SolverError when a coarser run finds no solution, and Interrupted.
ErrorEstimate estimate_errors(const Case& input, const MechanicsRecord& mechanics,
                              const electrochemistry::IonSolution& ions, const Signals& signals,
                              int threads, base::Timers& timers,
                              const base::ProgressCallback& progress = base::no_progress);

/// Estimates the numerical error of a run's prediction of measured data, half the width of an error
/// band with one entry per row of the data [unit of the data]. Empty where the contact has no
/// coarser solutions.
/// Throws as `estimate_errors`.
std::vector<double> estimate_data_errors(const Case& input, const MechanicsRecord& mechanics,
                                         const electrochemistry::IonSolution& ions,
                                         const FitData& data, int threads);

/// Error estimate that has an error for no metric, and gives a reason for each in `not_estimated`.
ErrorEstimate no_estimate(const Signals& signals, const std::string& reason);

/// Estimates the errors of a run of Study 1 without ion transport, from its coarser solutions.
/// @param signals of the run, see `read_out_mechanics`
ErrorEstimate estimate_mechanics_errors(const Case& input, const MechanicsRecord& mechanics,
                                        const Signals& signals, int threads);

} // namespace ionskin::study
