// SPDX-License-Identifier: Apache-2.0
#include "grid_graph.hpp"
#include "ionskin/linear_algebra/fill_ordering.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <new>
#include <thread>
#include <vector>

namespace {
bool metis_out_of_memory = false;
}

/// Stands before METIS's own for all of this program, CHOLMOD's library too.
extern "C" int METIS_NodeND(int* size, int* start, int* neighbours, int* weights, int* options,
                            int* order, int* inverse) {
  if (metis_out_of_memory) {
    std::fill_n(order, *size, -1);
    return -3; // METIS_ERROR_MEMORY
  }
  static const auto metis =
      reinterpret_cast<decltype(&METIS_NodeND)>(dlsym(RTLD_NEXT, "METIS_NodeND"));
  return metis(size, start, neighbours, weights, options, order, inverse);
}

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

TEST(FillOrdering, MetisWithoutMemoryIsNoOrder) {
  metis_out_of_memory = true;
  EXPECT_THROW(trailing_ordering(grid_graph(8), {3}), std::bad_alloc);
  metis_out_of_memory = false;
  EXPECT_EQ(trailing_ordering(grid_graph(8), {3}).back(), 3);
}

} // namespace
} // namespace ionskin::linear_algebra
