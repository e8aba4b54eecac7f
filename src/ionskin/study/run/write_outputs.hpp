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

/// Results of a run beside the record of its mechanics; input of `write_outputs`.
struct RunOutputs {
  /// Ion transport; empty in runs of the mechanics only.
  std::optional<electrochemistry::IonSolution> ions;
  Signals signals;
  std::vector<std::string> warnings;
  std::vector<Audit> audits;
  ErrorEstimate errors;
  /// Wall time of parts of the stages, for the manifest [s].
  std::map<std::string, double> stage_seconds;
};

/// Returns the outcome of a run that an earlier process has finished, read from its folder; draws
/// the report if it is missing.
/// @param start of this run on the clock of `base::wall_time` [s]
RunOutcome complete_report(const RunOptions& options, double start, RunFolder& folder);

/// Writes every file of a run from its signals and records, the report last, and marks the run as
/// finished or, where an audit failed, as failed.
/// @param start of the run on the clock of `base::wall_time` [s]
RunOutcome write_outputs(const Case& input, const RunOptions& options,
                         const MechanicsRecord& mechanics, const RunOutputs& outputs, double start,
                         RunFolder& folder);

/// Writes the signals and sampled currents, as far as there are any, and summary.json of a run that
/// a solver gave up. Leaves `results.h5` as it is, for `--resume`.
/// @param start of the run on the clock of `base::wall_time` [s]
void write_unfinished(const Case& input, const RunOutputs& outputs, double start,
                      RunFolder& folder);

} // namespace ionskin::study
