// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace ionskin::parallel {

/// Threads of some tasks that have found no further task, and may help with the tasks in work. All
/// threads together never exceed those that the tasks were given.
class SpareThreads {
public:
  /// False where there is none.
  bool take() {
    int count = count_;
    while (count > 0 && !count_.compare_exchange_weak(count, count - 1)) {
    }
    return count > 0;
  }
  void give() { ++count_; }

private:
  std::atomic<int> count_{0};
};

} // namespace ionskin::parallel
