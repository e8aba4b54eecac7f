// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/study/sweep/sweep_folder.hpp"
#include "ionskin/study/sweep/sweep_record.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::study {

/// Solves points of a sweep in a staging place and puts their folders under `points`: those of one
/// batch, or all. A point that fails is put there too, with its reason.
class SweepWork {
public:
  /// @param options of one point's run but for its folder and its threads
  /// @param chosen points whose cases have been read
  SweepWork(const SweepPlan& plan, const std::vector<std::size_t>& chosen, RunOptions options,
            const StagingPlace& place, SweepRecord& record);

  /// Mechanics is shared between the points wherever it can be.
  void solve_mechanics(base::Timers& timers, const std::filesystem::path& finished_points);
  /// The rest of the points, side by side, within the threads and a memory bound.
  void run_points();

private:
  void run_point(std::size_t point, RunOptions options);
  void fail(std::size_t point, const std::string& reason);

  const SweepPlan& plan_;
  RunOptions options_;
  const StagingPlace& place_;
  SweepRecord& record_;
  std::vector<std::size_t> unfinished_;
};

} // namespace ionskin::study
