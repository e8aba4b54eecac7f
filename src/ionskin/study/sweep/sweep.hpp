// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

struct SweepOptions {
  std::filesystem::path folder;
  int threads = 1;
  bool overwrite = false;          ///< replace the results of an earlier sweep
  bool resume = false;             ///< finish what an earlier sweep of the same points lacks
  Studies studies = Studies::both; ///< or `mechanics`
  bool report = true;              ///< draw the figures and the page of the whole sweep
  bool use_cache = true;           ///< of condensed slider positions
  std::string command;             ///< for the manifests
  base::ProgressCallback progress = base::no_progress; ///< called from one thread at a time
};

struct SweepOutcome {
  std::size_t points = 0;
  std::map<std::string, std::string> failures; ///< reason by name of the point
  std::filesystem::path report;                ///< empty when none was made
  std::string report_problem;                  ///< why none was made
  double seconds = 0;
};

/// Runs every point of a plan as a run folder of its own under `points`, and writes sweep.csv
/// (after every point) and sweep.h5. Mechanics is shared between points wherever it can be; then
/// the points run side by side, within the threads and a memory bound. A point that fails is a row
/// with its reason. Finished points outlive an interruption, which leaves as Interrupted. Throws
/// UserError before any work.
SweepOutcome run_sweep(const SweepPlan& plan, const SweepOptions& options);

} // namespace ionskin::study
