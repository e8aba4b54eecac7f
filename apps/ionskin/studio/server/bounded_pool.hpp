// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ionskin::apps::studio {

/// Workers of the server. When too many connections wait, no more are accepted until one is served.
class BoundedPool : public httplib::TaskQueue {
public:
  BoundedPool(std::size_t workers, std::size_t waiting);
  ~BoundedPool() override = default;
  void enqueue(std::function<void()> task) override;
  void shutdown() override;

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
