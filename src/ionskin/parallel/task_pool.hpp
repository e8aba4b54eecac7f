// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/spare_threads.hpp"

#include <cstddef>
#include <functional>

namespace ionskin::parallel {

/// Runs `task(0) ... task(count - 1)` on at most `threads` threads and waits for all of them.
/// Tasks must not depend on each other. When tasks throw, the remaining ones are not started and
/// the exception of the lowest index is rethrown.
/// @param spare receives the threads that find no further task; none when null
void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task,
               SpareThreads* spare = nullptr);

/// Runs `task(0) ... task(count - 1)` on the calling thread, helped by spare threads, and waits for
/// all of them; exceptions as in `run_tasks`.
void run_tasks_with_help(std::size_t count, SpareThreads& spare,
                         const std::function<void(std::size_t)>& task);

} // namespace ionskin::parallel
