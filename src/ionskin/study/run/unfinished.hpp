// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <optional>

namespace ionskin::study {

/// Writes the results of a run whose contact solver gave up: signals up to that instant, no
/// metrics, and the reason with its remedy in summary.json.
/// @param path contact states up to that instant; empty where not even the first load step was
/// solved
/// @param error that ended the solver
/// @param start of the run on the clock of `base::wall_time` [s]
void keep_unfinished_contact(const Case& input, const RunOptions& options,
                             const std::optional<mechanics::ContactSolution>& path,
                             const SolverError& error, double start, RunFolder& folder);

/// Writes the results of a run whose ion transport solver gave up: signals of both studies up to
/// that instant, the metrics of the finished Study 1, and the reason with its remedy in
/// summary.json.
/// @param ions solution up to that instant; null where there is none
/// @param error that ended the solver
/// @param start of the run on the clock of `base::wall_time` [s]
void keep_unfinished_ions(const Case& input, const RunOptions& options,
                          const MechanicsRecord& mechanics,
                          const electrochemistry::IonSolution* ions, const SolverError& error,
                          double start, RunFolder& folder);

} // namespace ionskin::study
