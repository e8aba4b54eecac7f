// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sched.h>

#include <algorithm>
#include <thread>

namespace ionskin::apps {

/// Number of processors on which this process may run, at least 1. Batch systems and `taskset` may
/// allow fewer than the machine has.
inline int usable_processors() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    return std::max(1, CPU_COUNT(&allowed));
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Number of threads with which a command runs.
/// @param wanted value of --threads; 0: one thread for each usable processor
inline int thread_count(int wanted) {
  return wanted > 0 ? wanted : usable_processors();
}

} // namespace ionskin::apps
