// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>

namespace ionskin::parallel {

/// Reports the progress of one activity from several threads, one at a time. How many units
/// of work there will be is known only in the end: what is reported never falls, and reaches 1 with
/// `finish`.
class SharedProgress {
public:
  /// @param callback must outlive this
  SharedProgress(std::string activity, const base::ProgressCallback& callback)
      : activity_(std::move(activity)), callback_(callback) {}

  /// Units that are done from now on make up to a share of the progress that is left.
  /// @param expected so many units; more make each of them count for less
  void begin_pass(std::size_t expected, double share);
  /// Declares that no more units are expected than were added.
  void expect_known_units();
  void add_units(std::size_t units);
  void finish_unit();
  void finish();

private:
  std::string activity_;
  const base::ProgressCallback& callback_;
  std::size_t expected_ = 0, known_ = 0, finished_ = 0; ///< of the pass
  double reported_ = 0, end_ = 1;
  std::mutex mutex_;
};

} // namespace ionskin::parallel
