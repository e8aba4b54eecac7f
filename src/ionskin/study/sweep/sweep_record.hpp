// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"

#include <filesystem>
#include <mutex>
#include <vector>

namespace ionskin::study {

/// States of the points of a sweep while they are solved, with the progress over the points in work
/// and the table sweep.csv on disk. Thread-safe, but for `states`.
class SweepRecord {
public:
  /// Record of all points of a sweep.
  /// @param points must outlive this object
  /// @param states of all points, as read from their run folders
  /// @param table file that is rewritten after every point; empty for none
  SweepRecord(const std::vector<SweepPoint>& points, std::vector<PointState> states,
              base::ProgressCallback progress, std::filesystem::path table);

  /// Begins work on some points and returns the indices of those that are not finished; failed
  /// points count as not finished.
  /// @param chosen indices of the points to work on
  std::vector<std::size_t> begin(const std::vector<std::size_t>& chosen);
  /// Sets the final state of a point, and rewrites the table.
  void settle(std::size_t point, PointState state);
  /// Sets the finished fraction of a point, 0 to 1.
  void progress(std::size_t point, double fraction);
  const std::vector<PointState>& states() const { return states_; }

private:
  void write_table() const;
  void show() const;

  const std::vector<SweepPoint>& points_;
  std::vector<PointState> states_;
  base::ProgressCallback progress_;
  std::filesystem::path table_;
  std::vector<std::size_t> chosen_;
  std::vector<double> fractions_;
  std::mutex mutex_;
};

} // namespace ionskin::study
