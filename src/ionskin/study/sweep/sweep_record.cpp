// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_record.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::study {

SweepRecord::SweepRecord(const std::vector<SweepPoint>& points, std::vector<PointState> states,
                         base::ProgressCallback progress, std::filesystem::path table)
    : points_(points), states_(std::move(states)), progress_(std::move(progress)),
      table_(std::move(table)), fractions_(points.size(), 0.0) {}

std::vector<std::size_t> SweepRecord::begin(const std::vector<std::size_t>& chosen) {
  const std::lock_guard lock(mutex_);
  chosen_ = chosen;
  std::vector<std::size_t> result;
  for (const std::size_t i : chosen) {
    const bool finished = states_[i].status == PointStatus::finished;
    fractions_[i] = finished ? 1 : 0;
    if (!finished) {
      states_[i] = {};
      result.push_back(i);
    }
  }
  write_table();
  return result;
}

void SweepRecord::settle(std::size_t point, PointState state) {
  const std::lock_guard lock(mutex_);
  states_[point] = std::move(state);
  fractions_[point] = 1;
  write_table();
  show();
}

void SweepRecord::progress(std::size_t point, double fraction) {
  const std::lock_guard lock(mutex_);
  fractions_[point] = std::max(fractions_[point], fraction);
  show();
}

void SweepRecord::write_table() const {
  if (!table_.empty()) {
    base::write_text_file(table_, sweep_table_text(points_, states_));
  }
}

void SweepRecord::show() const {
  double sum = 0;
  for (const std::size_t i : chosen_) {
    sum += fractions_[i];
  }
  progress_("ion transport of all points", sum / static_cast<double>(chosen_.size()));
}

} // namespace ionskin::study
