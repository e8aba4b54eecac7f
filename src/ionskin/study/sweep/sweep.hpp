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

/// Options of a sweep, and where its results go.
struct SweepOptions {
  std::filesystem::path folder;
  int threads = 1;
  bool overwrite = false;          ///< replace the results of an earlier sweep
  bool resume = false;             ///< finish what an earlier sweep of the same points lacks
  Studies studies = Studies::both; ///< or `mechanics`
  bool report = true;              ///< write the page of the whole sweep
  bool figures = false;            ///< true if the figures are written as files
  std::string command;             ///< for the manifests
  base::ProgressCallback progress = base::no_progress; ///< called from one thread at a time
};

/// Outcome of a sweep.
struct SweepOutcome {
  std::size_t points = 0;
  std::map<std::string, std::string> failures; ///< reason by name of the point
  std::vector<std::string> missing;            ///< names of the points that nobody solved yet
  std::filesystem::path report;                ///< empty when none was made
  std::string report_problem;                  ///< reason why none was made
  double seconds = 0;
};

/// Plans a sweep, does all its points and collects the tables. Every point is a run folder of its
/// own under `points`, which appears there when it is whole; sweep.csv is written after every
/// point. Mechanics is shared between points wherever it can be; then the points run side by side,
/// within the threads and a memory bound. A point that fails is a row with its reason. Finished
/// points outlive an interruption, which leaves as Interrupted. Throws UserError before any work.
SweepOutcome run_sweep(const SweepPlan& plan, const SweepOptions& options);

/// Contents of a planned sweep.
struct PlannedFolder {
  std::vector<SweepBatch> batches;
  std::vector<std::size_t> unfinished; ///< numbers of the batches that have points to be solved
};

/// Writes plan.json and the manifest of a sweep, whose batches other processes then do.
/// @param options `threads` are those of a batch
PlannedFolder plan_sweep_folder(const SweepPlan& plan, const SweepOptions& options);

/// Does one batch of a planned sweep, beside other processes that do others: solves what is not
/// finished of its points, and tries those again that failed. Touches no table.
/// @param options `folder`, `threads` (0: as planned), `command` and `progress`
/// Throws UserError before any work.
SweepOutcome do_batch(std::size_t batch, const SweepOptions& options);

/// Writes the tables of a planned sweep from the points that are there, and the report. May be
/// called while batches are being done.
/// @param options `folder`, `report`, `command` and `progress`
SweepOutcome collect_sweep(const SweepOptions& options);

} // namespace ionskin::study
