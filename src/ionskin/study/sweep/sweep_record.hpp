// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"

#include <filesystem>
#include <mutex>
#include <vector>

namespace ionskin::study {

/// Record of the points of a sweep while they are solved: their states, the progress over those
/// that are worked on, and the table on disk. May be called from several threads.
class SweepRecord {
public:
  /// @param states of all points, as their folders tell them
  /// @param table file to write after every point; none when empty
  SweepRecord(const std::vector<SweepPoint>& points, std::vector<PointState> states,
              base::ProgressCallback progress, std::filesystem::path table);

  /// Points among the given ones that are not finished; failed ones are tried again.
  std::vector<std::size_t> begin(const std::vector<std::size_t>& chosen);
  void settle(std::size_t point, PointState state);
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
