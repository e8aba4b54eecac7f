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

/// The stated errors of a run of both studies. What Study 1 leaves goes through the ion transport:
/// the histories of its coarser solutions, and the history of the run on wider cells, are run
/// through Study 2 on twice the mesh sizes and up to twice the time steps, and compared with the
/// run's own history there. Two more runs tell what that grid and those steps leave.
/// docs/errors-of-results.md says how the differences become errors. Parts of the mechanics are
/// missing for a given strain; without coarser solutions nothing is estimated. Stage in `timers`:
/// "error estimate". Throws SolverError when a coarser run finds no solution, and Interrupted.
/// @param progress called with "error estimate"
ErrorEstimate estimate_errors(const Case& input, const MechanicsRecord& mechanics,
                              const electrochemistry::IonSolution& ions, const Signals& signals,
                              int threads, base::Timers& timers,
                              const base::ProgressCallback& progress = base::no_progress);

/// Half the width of the band about what a run says to measured data, one entry per row [unit of
/// the data]; empty where the mechanics has no coarser solutions. Throws as above.
std::vector<double> estimate_data_errors(const Case& input, const MechanicsRecord& mechanics,
                                         const electrochemistry::IonSolution& ions,
                                         const FitData& data, int threads);

/// No error of any metric, with the reason.
ErrorEstimate no_estimate(const Signals& signals, const std::string& reason);

/// Errors of Study 1 alone.
ErrorEstimate estimate_mechanics_errors(const Case& input, const MechanicsRecord& mechanics,
                                        const Signals& signals, int threads);

} // namespace ionskin::study
