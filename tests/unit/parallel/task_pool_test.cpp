// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/task_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace ionskin::parallel {
namespace {

using namespace std::chrono_literals;

TEST(TaskPool, RunsEveryTaskOnce) {
  std::vector<std::atomic<int>> runs(100);
  run_tasks(runs.size(), 3, [&](std::size_t i) { ++runs[i]; });
  for (const auto& count : runs) {
    EXPECT_EQ(count, 1);
  }
}

TEST(TaskPool, NoTasksIsNoWork) {
  run_tasks(0, 4, [](std::size_t) { FAIL(); });
}

TEST(TaskPool, NeverUsesMoreThreadsThanAllowed) {
  std::atomic<int> running{0};
  std::atomic<int> most{0};
  run_tasks(20, 2, [&](std::size_t) {
    const int now = ++running;
    int seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
    std::this_thread::sleep_for(1ms); // long enough to meet whoever else runs
    --running;
  });
  EXPECT_EQ(most, 2);
}

TEST(TaskPool, RethrowsTheFailureOfTheLowestIndexThoughAnotherCameFirst) {
  std::atomic<bool> other_fails{false};
  try {
    run_tasks(2, 2, [&](std::size_t i) {
      if (i == 0) {
        const auto limit = std::chrono::steady_clock::now() + 10s; // without a second thread
        while (!other_fails && std::chrono::steady_clock::now() < limit) {
          std::this_thread::yield();
        }
        EXPECT_TRUE(other_fails);
        std::this_thread::sleep_for(20ms); // until the other has thrown
      } else {
        other_fails = true;
      }
      throw std::runtime_error(std::to_string(i));
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "0");
  }
}

TEST(TaskPool, StartsNoTaskAfterAFailure) {
  int started = 0;
  EXPECT_THROW(run_tasks(4, 1,
                         [&](std::size_t i) {
                           ++started;
                           if (i == 1) {
                             throw std::runtime_error("");
                           }
                         }),
               std::runtime_error);
  EXPECT_EQ(started, 2);
}

} // namespace
} // namespace ionskin::parallel
