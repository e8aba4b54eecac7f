// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/task_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace ionskin::parallel {
namespace {

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
  run_tasks(50, 2, [&](std::size_t) {
    const int now = ++running;
    int seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
    --running;
  });
  EXPECT_LE(most, 2);
}

TEST(TaskPool, RethrowsTheFailureOfTheLowestIndex) {
  try {
    run_tasks(4, 1, [](std::size_t i) {
      if (i >= 1) {
        throw std::runtime_error(std::to_string(i));
      }
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "1");
  }
}

} // namespace
} // namespace ionskin::parallel
