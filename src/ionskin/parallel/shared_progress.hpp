// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>

namespace ionskin::parallel {

/// Thread-safe progress of one activity that several threads work on; calls of the callback never
/// overlap. The number of units of work may grow while they are done; the reported fraction never
/// falls all the same, and reaches 1 with `finish`.
class SharedProgress {
public:
  /// Progress of a named activity, nothing done yet.
  /// @param activity name that is passed to the callback
  /// @param callback receives the activity and the finished fraction in [0, 1]; must outlive this
  /// object
  SharedProgress(std::string activity, const base::ProgressCallback& callback)
      : activity_(std::move(activity)), callback_(callback) {}

  /// Begins a pass: its units together advance the reported fraction by `share` of what is left to
  /// 1.
  /// @param expected number of units in the pass; if more are finished, each advances the fraction
  /// less
  /// @param share of the remaining progress, 0 to 1
  void begin_pass(std::size_t expected, double share);
  /// Announces further units of the pass; they count where they exceed the expected number.
  void add_units(std::size_t units);
  /// Marks one unit as finished and reports the new fraction.
  void finish_unit();
  /// Reports the fraction 1.
  void finish();

private:
  std::string activity_;
  const base::ProgressCallback& callback_;
  std::size_t expected_ = 0, known_ = 0, finished_ = 0; ///< units of the current pass
  double reported_ = 0, end_ = 1;
  std::mutex mutex_;
};

} // namespace ionskin::parallel
