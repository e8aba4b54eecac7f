// SPDX-License-Identifier: Apache-2.0
#include "grid_graph.hpp"
#include "ionskin/linear_algebra/fill_ordering.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

namespace ionskin::linear_algebra {
namespace {

volatile std::sig_atomic_t signals_taken = 0;

TEST(FillOrdering, LeavesTheTerminationSignalToTheProgram) {
  const SymmetricPattern graph = grid_graph(24);
  const std::vector<int> undisturbed = trailing_ordering(graph, {});
  const auto take = [](int) { signals_taken = signals_taken + 1; };
  const auto former = std::signal(SIGTERM, take);
  {
    const std::jthread sender([here = pthread_self()](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        pthread_kill(here, SIGTERM);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(trailing_ordering(graph, {}), undisturbed);
    }
  }
  EXPECT_EQ(std::signal(SIGTERM, former), +take);
  EXPECT_GT(signals_taken, 0);
}

} // namespace
} // namespace ionskin::linear_algebra
