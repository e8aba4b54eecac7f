// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/worker_team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <vector>

namespace ionskin::parallel {
namespace {

TEST(WorkerTeam, EveryIndexIsVisitedOnceInEveryLoop) {
  for (const int threads : {1, 2, 5}) {
    WorkerTeam team(threads);
    for (std::size_t count = 0; count < 300; ++count) {
      std::vector<int> visits(count, 0);
      team.for_blocks(count, 4, [&](std::size_t begin, std::size_t end, std::size_t worker) {
        EXPECT_EQ(begin % 4, 0U);
        EXPECT_LT(worker, team.size());
        for (std::size_t i = begin; i < end; ++i) {
          ++visits[i];
        }
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(WorkerTeam, LoopsFollowEachOtherWithoutMixing) {
  WorkerTeam team(3);
  std::vector<std::size_t> value(64, 0);
  for (std::size_t loop = 0; loop < 20000; ++loop) {
    team.for_blocks(value.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        value[i] += value[i] == loop ? 1 : 1000000;
      }
    });
  }
  EXPECT_EQ(value, std::vector<std::size_t>(64, 20000));
}

void busy_for(std::chrono::microseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
  }
}

// The other thread is slow, as where it has to wait for a processor.
TEST(WorkerTeam, GoesOnAloneWhereOthersMakeItSlower) {
  WorkerTeam team(2);
  constexpr int loops = 10000;
  std::atomic<int> helped{0};
  for (int loop = 0; loop < loops; ++loop) {
    team.for_blocks(4, 1, [&](std::size_t begin, std::size_t end, std::size_t worker) {
      helped += worker > 0 ? 1 : 0;
      busy_for(static_cast<int>(end - begin) * std::chrono::microseconds(worker > 0 ? 60 : 5));
    });
  }
  EXPECT_LT(helped, loops / 5);
}

} // namespace
} // namespace ionskin::parallel
