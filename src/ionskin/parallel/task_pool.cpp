// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/task_pool.hpp"

#include "ionskin/base/system/blocked_signal.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace ionskin::parallel {

void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
  std::vector<std::exception_ptr> failures(count);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  auto work = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++) {
      try {
        task(i);
      } catch (...) {
        failures[i] = std::current_exception();
        failed = true;
      }
    }
  };
  const auto workers = std::min<std::size_t>(count, static_cast<std::size_t>(std::max(1, threads)));
  {
    std::vector<std::jthread> pool;
    {
      const base::BlockedSignal for_the_main_thread(SIGTERM);
      for (std::size_t i = 1; i < workers; ++i) {
        pool.emplace_back(work);
      }
    }
    work();
  }
  for (const auto& failure : failures) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
}

} // namespace ionskin::parallel
