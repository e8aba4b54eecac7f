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

/// Number of pieces of work: enough for every thread to come, however busy the machine is.
constexpr int pieces = 3000;

/// Yields until `holds`, but not for ever: then what the test expects does not come.
template <class Condition>
void wait_until(const Condition& holds, std::chrono::milliseconds longest = 60s) {
  const auto limit = std::chrono::steady_clock::now() + longest;
  while (!holds() && std::chrono::steady_clock::now() < limit) {
    std::this_thread::yield();
  }
}

/// Most threads at work at the same time, and all work done. Work waits a while for those that are
/// expected: a thread that asks for help does so between two pieces of its work.
class Census {
public:
  explicit Census(int expected) : expected_(expected) {}
  void work() {
    const int now = ++running_;
    int seen = most_;
    while (now > seen && !most_.compare_exchange_weak(seen, now)) {
    }
    wait_until([this] { return most_ >= expected_; }, 20ms);
    if (++all_ < 100) {
      std::this_thread::sleep_for(1ms); // long enough to meet one too many
    }
    --running_;
  }
  int most() const { return most_; }
  int all() const { return all_; }

private:
  int expected_;
  std::atomic<int> running_{0}, most_{0}, all_{0};
};

TEST(TaskPool, NeverUsesMoreThreadsThanAllowed) {
  Census census(2);
  run_tasks(pieces, 2, [&](std::size_t) { census.work(); });
  EXPECT_EQ(census.most(), 2);
}

TEST(TaskPool, RethrowsTheFailureOfTheLowestIndexThoughAnotherCameFirst) {
  std::atomic<bool> other_fails{false};
  try {
    run_tasks(2, 2, [&](std::size_t i) {
      if (i == 0) {
        wait_until([&] { return other_fails.load(); });
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

TEST(TaskPool, ThreadsWithoutATaskHelpWithTheLastOne) {
  Census first(1), last(3);
  SpareThreads spare;
  run_tasks(
      4, 3,
      [&](std::size_t task) {
        run_tasks_with_help(pieces, spare, [&](std::size_t) { (task == 3 ? last : first).work(); });
      },
      &spare);
  EXPECT_EQ(first.all(), 3 * pieces);
  EXPECT_EQ(last.all(), pieces);
  EXPECT_LE(first.most(), 3);
  EXPECT_EQ(last.most(), 3);
}

TEST(TaskPool, ThreadsBeyondTheTasksHelpFromTheBeginning) {
  Census census(3);
  SpareThreads spare;
  run_tasks(
      1, 3,
      [&](std::size_t) { run_tasks_with_help(pieces, spare, [&](std::size_t) { census.work(); }); },
      &spare);
  EXPECT_EQ(census.most(), 3);
}

TEST(TaskPool, WithoutASpareThreadTheCallerDoesAll) {
  SpareThreads none;
  const auto caller = std::this_thread::get_id();
  int runs = 0;
  run_tasks_with_help(5, none, [&](std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    ++runs;
  });
  EXPECT_EQ(runs, 5);
}

TEST(TaskPool, AFailureOfAHelperIsTheCallers) {
  SpareThreads spare;
  spare.give();
  const auto caller = std::this_thread::get_id();
  std::atomic<bool> helper_came{false};
  EXPECT_THROW(run_tasks_with_help(2, spare,
                                   [&](std::size_t) {
                                     if (std::this_thread::get_id() != caller) {
                                       helper_came = true;
                                       throw std::runtime_error("");
                                     }
                                     wait_until([&] { return helper_came.load(); });
                                   }),
               std::runtime_error);
  EXPECT_TRUE(spare.take()); // the helper has given itself back
  EXPECT_FALSE(spare.take());
}

} // namespace
} // namespace ionskin::parallel
