// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace ionskin::parallel {

/// Runs `task(0) ... task(count - 1)` on at most `threads` threads and waits for all of them.
/// Tasks must not depend on each other. When tasks throw, the remaining ones are not started and
/// the exception of the lowest index is rethrown.
void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

} // namespace ionskin::parallel
