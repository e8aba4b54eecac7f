// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/metrics/audits.hpp"
#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Everything a run has computed beside the mechanics.
struct RunOutputs {
  std::optional<electrochemistry::IonSolution> ions; ///< empty in runs of the mechanics alone
  Signals signals;
  std::vector<std::string> warnings;
  std::vector<Audit> audits;
  ErrorEstimate errors;
  std::map<std::string, double> stage_seconds; ///< parts of the stages, for the manifest [s]
};

/// The outcome of a run that an earlier one has finished; draws the report if it is missing.
RunOutcome complete_report(const RunOptions& options, double start, RunFolder& folder);

/// Signals -> Results: writes every file of a run, the report last.
/// @param start of the run on the clock of `base::wall_time` [s]
RunOutcome write_outputs(const Case& input, const RunOptions& options,
                         const MechanicsRecord& mechanics, const RunOutputs& outputs, double start,
                         RunFolder& folder);

/// Writes signals and sampled currents, if there are any, and the summary of a run that a solver
/// gave up; `results.h5` stays as it is, for `--resume`.
void write_unfinished(const Case& input, const RunOutputs& outputs, double start,
                      RunFolder& folder);

} // namespace ionskin::study
