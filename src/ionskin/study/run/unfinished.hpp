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

/// Leaves what a contact was solved for before its solver gave up: signals until then, no figures,
/// and in summary.json why and the remedy.
/// @param path as far as it went; empty where not even the first step was solved
/// @param start of the run on the clock of `base::wall_time` [s]
void keep_unfinished_contact(const Case& input, const RunOptions& options,
                             const std::optional<mechanics::ContactSolution>& path,
                             const SolverError& error, double start, RunFolder& folder);

/// Leaves the results of a run whose ion transport gave up: its signals as far as they go, and the
/// figures of Study 1, which is finished.
/// @param ions until then; null where there is nothing of them
void keep_unfinished_ions(const Case& input, const RunOptions& options,
                          const MechanicsRecord& mechanics,
                          const electrochemistry::IonSolution* ions, const SolverError& error,
                          double start, RunFolder& folder);

} // namespace ionskin::study
