// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/timers.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace ionskin::base {
namespace {

TEST(Timers, ScopesAddUpPerStage) {
  Timers timers;
  timers.add("mechanics", 1.5);
  timers.add("mechanics", 0.5);
  const auto begun = std::chrono::steady_clock::now();
  { const Timers::Scope scope(timers, "strain"); }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
  const auto seconds = timers.seconds();
  EXPECT_DOUBLE_EQ(seconds.at("mechanics"), 2.0);
  EXPECT_GE(seconds.at("strain"), 0.0);
  EXPECT_LE(seconds.at("strain"), passed.count());
}

TEST(Timers, PeakMemoryCoversWhatWasTouched) {
  const double before = peak_memory();
  std::vector<char> block(64 << 20, 1);
  EXPECT_GT(before, 0);
  EXPECT_GE(peak_memory(), static_cast<double>(block.size()));
}

} // namespace
} // namespace ionskin::base
