// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/timers.hpp"
#include "ionskin/study/sweep/sweep_folder.hpp"
#include "ionskin/study/sweep/sweep_record.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::study {

/// Solves points of a sweep, all or those of one batch, in a staging folder, and moves their run
/// folders to `points`. A point that fails is moved there, too, with its reason.
class SweepWork {
public:
  /// Work on the points that are not finished; all references must outlive this object.
  /// @param chosen indices of the points, whose cases have been read
  /// @param options of one point's run, without its folder; `threads` is the number for all points
  /// together
  /// @param place staging folder
  /// @param record states of the points, kept up to date
  SweepWork(const SweepPlan& plan, const std::vector<std::size_t>& chosen, RunOptions options,
            const StagingPlace& place, SweepRecord& record);

  /// Solves Study 1 of the points; points share solution and skin wherever they can.
  /// @param finished_points folder with run folders from which the same Study 1 is copied
  void solve_mechanics(base::Timers& timers, const std::filesystem::path& finished_points);
  /// Solves the rest of each point, in parallel within the threads and a bound on memory.
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
