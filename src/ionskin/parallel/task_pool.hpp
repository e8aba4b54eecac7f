// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/parallel/spare_threads.hpp"

#include <cstddef>
#include <functional>

namespace ionskin::parallel {

/// Runs `task(0) ... task(count - 1)` on at most `threads` threads, the calling one included, and
/// waits for all of them. Tasks must not depend on each other. When a task throws, tasks not yet
/// started are skipped, and of the exceptions thrown the one with the lowest index is rethrown.
/// @param spare counts each thread that finds no further task, so that others can use it; null:
/// threads are not passed on
void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task,
               SpareThreads* spare = nullptr);

/// Runs `task(0) ... task(count - 1)` on the calling thread, helped by as many threads as `spare`
/// gives, and waits for all of them; helpers return to `spare` afterwards. Exceptions as in
/// `run_tasks`.
void run_tasks_with_help(std::size_t count, SpareThreads& spare,
                         const std::function<void(std::size_t)>& task);

} // namespace ionskin::parallel
