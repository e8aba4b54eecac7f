// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ionskin::apps::studio {

/// Pool of worker threads that answer the server's requests, with a bounded queue.
class BoundedPool {
public:
  /// Starts the threads.
  /// @param workers number of threads
  /// @param waiting number of tasks that may wait for a thread
  BoundedPool(std::size_t workers, std::size_t waiting);
  /// Waits until all enqueued tasks have run.
  ~BoundedPool();
  BoundedPool(const BoundedPool&) = delete;
  BoundedPool& operator=(const BoundedPool&) = delete;
  /// Adds a task to the queue; blocks while the queue is full.
  void enqueue(std::function<void()> task);

private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::size_t waiting_;
  bool ends_ = false;
  std::vector<std::thread> threads_;
};

} // namespace ionskin::apps::studio
