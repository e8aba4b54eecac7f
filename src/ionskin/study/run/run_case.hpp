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

/// Studies that a run does.
enum class Studies { both, mechanics, electrochemistry };

/// Options of a run, and where its results go.
struct RunOptions {
  std::filesystem::path folder; ///< of the results
  int threads = 1;
  bool overwrite = false;     ///< replace the results of an earlier run
  bool resume = false;        ///< take up the finished parts of an interrupted run of the same case
  bool beside_others = false; ///< others may write other results into the folder meanwhile
  /// `electrochemistry` alone takes up the finished mechanics in the folder.
  Studies studies = Studies::both;
  bool report = true;          ///< write the page
  bool figures = false;        ///< true if the figures are written as files
  bool paraview = true;        ///< write the kept fields for ParaView, beside those in results.h5
  bool judge_resources = true; ///< before any work; off where that was done and Study 1 is solved
  std::string command;         ///< for the manifest
  base::ProgressCallback progress = base::no_progress;
};

/// Results and warnings of a run.
struct RunOutcome {
  std::filesystem::path folder;
  std::filesystem::path report; ///< empty when no report was made
  std::string
      report_problem; ///< reason why one that was wanted was not made; among the warnings too
  std::vector<readout::Metric> metrics;
  ErrorEstimate errors;
  std::vector<std::string> warnings;
  double seconds = 0;
};

/// Runs one case and writes its results. What is finished is on disk before the next part starts.
/// Throws UserError before any work, SolverError and Interrupted with the finished parts kept.
RunOutcome run_case(const Case& input, const RunOptions& options);

} // namespace ionskin::study
