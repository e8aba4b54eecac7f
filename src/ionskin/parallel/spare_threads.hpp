// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace ionskin::parallel {

/// Thread-safe count of threads that have run out of tasks of their own and may help with tasks
/// still in progress elsewhere. Sharing them keeps the total within the number of threads that the
/// tasks were given.
class SpareThreads {
public:
  /// Takes one spare thread from the count. False if there is none.
  bool take() {
    int count = count_;
    while (count > 0 && !count_.compare_exchange_weak(count, count - 1)) {
    }
    return count > 0;
  }
  /// Adds one spare thread to the count.
  void give() { ++count_; }

private:
  std::atomic<int> count_{0};
};

} // namespace ionskin::parallel
