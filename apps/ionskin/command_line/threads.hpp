// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sched.h>

#include <algorithm>
#include <thread>

namespace ionskin::apps {

/// Processors that this process may run on: batch systems and `taskset` may leave it a part.
inline int usable_processors() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    return std::max(1, CPU_COUNT(&allowed));
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Number of threads that a command uses.
/// @param wanted value of --threads; 0 stands for all processors
inline int thread_count(int wanted) {
  return wanted > 0 ? wanted : usable_processors();
}

} // namespace ionskin::apps
