// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_plan_file.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// Options of the functions of a sweep, and the folder for its results.
struct SweepOptions {
  std::filesystem::path folder;
  int threads = 1;
  bool overwrite = false;          ///< replaces the results of an earlier sweep
  bool resume = false;             ///< solves only what an earlier sweep of the same points lacks
  Studies studies = Studies::both; ///< studies to run at each point: `both` or `mechanics`
  bool report = true;              ///< writes the report page of the whole sweep
  bool figures = false;            ///< writes the figures of the report as separate files, too
  std::string command;             ///< command line, recorded in the manifests
  base::ProgressCallback progress = base::no_progress; ///< called from one thread at a time
};

/// Outcome of a sweep or of one of its batches.
struct SweepOutcome {
  std::size_t points = 0;                      ///< number of points
  std::map<std::string, std::string> failures; ///< reasons of failed points, by name of the point
  std::vector<std::string> missing;            ///< names of points that are not solved yet
  std::filesystem::path report; ///< path of the report page; empty when none was made
  std::string report_problem;   ///< reason why a report that was asked for was not made
  double seconds = 0;           ///< wall time [s]
};

/// Plans a sweep, solves all its points and writes its tables. Each point has a run folder of its
/// own, which appears under `points` when it is complete; sweep.csv is rewritten after each point.
/// Points whose Study 1 is the same share its solution, and points that differ only in friction
/// share the skin; then the points run in parallel, within the threads and a bound on memory. A
/// point that fails is a row of the table with its reason. Finished points stay on disk when the
/// sweep is interrupted.
/// Throws UserError before any work, and Interrupted.
SweepOutcome run_sweep(const SweepPlan& plan, const SweepOptions& options);

/// Batches of a planned sweep. Made by `plan_sweep_folder`.
struct PlannedFolder {
  std::vector<SweepBatch> batches;
  /// Numbers (from 0) of the batches with points that are not finished.
  std::vector<std::size_t> unfinished;
};

/// Plans a sweep without solving it: writes plan.json and the manifest into its folder. Other
/// processes then solve the batches with `do_batch`.
/// @param options `threads` is the number of threads for one batch
/// Throws UserError, as for points that no machine can solve.
PlannedFolder plan_sweep_folder(const SweepPlan& plan, const SweepOptions& options);

/// Solves the points of one batch of a planned sweep that are not finished, and tries failed points
/// again. May run beside processes that solve other batches; writes no table.
/// @param batch number of the batch, from 0
/// @param options uses `folder`, `threads` (0: as planned), `command` and `progress`
/// Throws UserError before any work.
SweepOutcome do_batch(std::size_t batch, const SweepOptions& options);

/// Writes the tables of a planned sweep from the points that are finished, and the report. May be
/// called while batches are being solved.
/// @param options uses `folder`, `report`, `figures`, `command` and `progress`
/// Throws UserError when the folder holds no plan, or another process is collecting the tables.
SweepOutcome collect_sweep(const SweepOptions& options);

} // namespace ionskin::study
