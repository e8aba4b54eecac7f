// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/path_lock.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"

#include <filesystem>
#include <string>

namespace ionskin::study {

/// Reads the state of a point of a sweep from its run folder; of a finished point with its metrics.
/// @param points folder that holds the run folders of all points
/// @param studies `mechanics`: a finished Study 1 is enough
PointState read_point_state(const std::filesystem::path& points, const SweepPoint& point,
                            Studies studies);

/// Staging folder of one process inside the sweep's folder, in which points are solved before they
/// are moved to `points`, so that a point appears there only when it is complete. A second process
/// with the same work gets another staging folder; points that a killed process left are reused by
/// the next one on the same machine.
class StagingPlace {
public:
  /// Makes and locks a staging folder.
  /// @param sweep folder of the sweep
  /// @param work name of the work, such as "batch-0003"
  StagingPlace(const std::filesystem::path& sweep, const std::string& work);
  ~StagingPlace();
  StagingPlace(const StagingPlace&) = delete;
  StagingPlace& operator=(const StagingPlace&) = delete;

  /// Folder that holds the run folders of the points.
  const std::filesystem::path& path() const { return path_; }
  /// Moves the run folder of a point that has finished or failed to `points`, in place of what is
  /// there unless that is finished.
  /// Throws UserError when a file of the user is in the way.
  void publish(const SweepPoint& point, Studies studies) const;

private:
  std::filesystem::path sweep_, path_;
  results::PathLock lock_;
};

/// Moves finished and failed points from staging folders in which no process works to `points`:
/// those of killed processes, and those that came from another machine.
/// @param sweep folder of the sweep
/// @param clear true: removes unfinished points from these staging folders, which a repeated batch
/// would otherwise reuse
void settle_staging(const std::filesystem::path& sweep, const SweepPlan& plan, Studies studies,
                    bool clear);

} // namespace ionskin::study
