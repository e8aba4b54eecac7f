// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/study/errors/stated_errors.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// Studies that a run solves: contact mechanics (Study 1), ion transport (Study 2), or both.
enum class Studies { both, mechanics, electrochemistry };

/// Options of `run_case`, and the folder for its results.
struct RunOptions {
  std::filesystem::path folder; ///< output folder
  int threads = 1;
  bool overwrite = false; ///< replaces the results of an earlier run
  /// Reuses the finished parts of an interrupted run of the same case in the folder.
  bool resume = false;
  /// Lets other processes write other results into the folder meanwhile.
  bool beside_others = false;
  /// Studies to run. `electrochemistry` runs Study 2 only, and reads the finished Study 1 from the
  /// output folder.
  Studies studies = Studies::both;
  bool report = true;   ///< writes the report page report.html
  bool figures = false; ///< writes the figures of the report as separate files, too
  /// Writes the stored fields as files for ParaView, beside those in results.h5.
  bool paraview = true;
  /// Checks memory and disk space before any work; off where a caller, such as a sweep, has checked
  /// them.
  bool judge_resources = true;
  std::string command; ///< command line, recorded in manifest.json
  base::ProgressCallback progress = base::no_progress;
};

/// Results and warnings of a run, made by `run_case`; all of them are in the files of the folder,
/// too.
struct RunOutcome {
  std::filesystem::path folder;
  std::filesystem::path report; ///< path of report.html; empty when no report was made
  /// Reason why a report that was asked for could not be made, also among the warnings; empty
  /// otherwise.
  std::string report_problem;
  /// Scalar results, as in summary.json.
  std::vector<readout::Metric> metrics;
  /// Reported error estimates of metrics and signals.
  ErrorEstimate errors;
  std::vector<std::string> warnings;
  /// Wall time of the run [s].
  double seconds = 0;
};

/// Runs one case and writes its results into the output folder. Each finished part is on disk
/// before the next part starts, so that an interrupted run can be resumed.
/// Throws UserError before any work; SolverError when a solver gives up or the results fail an
/// audit, and Interrupted, with what is finished on disk.
RunOutcome run_case(const Case& input, const RunOptions& options);

} // namespace ionskin::study
