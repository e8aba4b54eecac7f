// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ionskin::apps::studio {

/// Workers of the server.
class BoundedPool {
public:
  BoundedPool(std::size_t workers, std::size_t waiting);
  /// Waits for the tasks that were enqueued.
  ~BoundedPool();
  BoundedPool(const BoundedPool&) = delete;
  BoundedPool& operator=(const BoundedPool&) = delete;
  /// Waits while too many tasks wait.
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
