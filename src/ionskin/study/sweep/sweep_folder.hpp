// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/path_lock.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"

#include <filesystem>
#include <string>

namespace ionskin::study {

/// State of a point, by its folder; a finished one with its metrics.
/// @param points folder of the points' folders
PointState read_point_state(const std::filesystem::path& points, const SweepPoint& point,
                            Studies studies);

/// Where points are solved, inside the sweep's folder: nobody sees a point's folder under `points`
/// before it is whole. A second process that does the same work has a place of its own; the points
/// that a killed process left are taken over by the next on the same machine.
class StagingPlace {
public:
  /// @param work names what is done, such as "batch-0003"
  StagingPlace(const std::filesystem::path& sweep, const std::string& work);
  ~StagingPlace();
  StagingPlace(const StagingPlace&) = delete;
  StagingPlace& operator=(const StagingPlace&) = delete;

  /// Folder of the points' folders.
  const std::filesystem::path& path() const { return path_; }
  /// Moves the folder of a point that is finished, or failed for a reason, to `points`, in place of
  /// what is there, unless that is finished. Throws UserError when a file of the user is in the
  /// way.
  void publish(const SweepPoint& point, Studies studies) const;

private:
  std::filesystem::path sweep_, path_;
  results::PathLock lock_;
};

/// Publishes finished points in staging places that no process works in: points that came from
/// another machine, and those of killed processes.
/// @param clear removes the rest, which a repeated batch would take up
void settle_staging(const std::filesystem::path& sweep, const SweepPlan& plan, Studies studies,
                    bool clear);

} // namespace ionskin::study
