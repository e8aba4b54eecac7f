// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/task_pool.hpp"

#include "ionskin/base/system/blocked_signal.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace ionskin::parallel {
namespace {

/// Tasks that several threads take one after another in the order of their index, with the
/// exceptions they threw.
class TaskQueue {
public:
  TaskQueue(std::size_t count, const std::function<void(std::size_t)>& task)
      : task_(task), failures_(count) {}

  /// Number of tasks that no thread has taken; 0 after a task has thrown.
  std::size_t left() const {
    const std::size_t next = next_;
    return failed_ || next > failures_.size() ? 0 : failures_.size() - next;
  }

  /// Runs the next task, if there is one; stores its exception if it throws.
  void run_next() {
    const std::size_t i = next_++;
    if (i >= failures_.size() || failed_) {
      return;
    }
    try {
      task_(i);
    } catch (...) {
      failures_[i] = std::current_exception();
      failed_ = true;
    }
  }

  void rethrow_first_failure() const {
    for (const auto& failure : failures_) {
      if (failure) {
        std::rethrow_exception(failure);
      }
    }
  }

private:
  const std::function<void(std::size_t)>& task_;
  std::vector<std::exception_ptr> failures_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
};

template <class Work> void start_thread(std::vector<std::jthread>& pool, const Work& work) {
  const base::BlockedSignal for_the_main_thread(SIGTERM);
  pool.emplace_back(work);
}

} // namespace

void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task,
               SpareThreads* spare) {
  TaskQueue queue(count, task);
  const auto work = [&] {
    while (queue.left() > 0) {
      queue.run_next();
    }
    if (spare != nullptr) {
      spare->give();
    }
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 1; i < threads; ++i) {
      if (static_cast<std::size_t>(i) < count) {
        start_thread(pool, work);
      } else if (spare != nullptr) {
        spare->give();
      }
    }
    work();
  }
  queue.rethrow_first_failure();
}

void run_tasks_with_help(std::size_t count, SpareThreads& spare,
                         const std::function<void(std::size_t)>& task) {
  TaskQueue queue(count, task);
  {
    std::vector<std::jthread> helpers;
    while (queue.left() > 0) {
      if (queue.left() > 1 && spare.take()) {
        start_thread(helpers, [&] {
          while (queue.left() > 0) {
            queue.run_next();
          }
          spare.give();
        });
      }
      queue.run_next();
    }
  }
  queue.rethrow_first_failure();
}

} // namespace ionskin::parallel
