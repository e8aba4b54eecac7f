// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/tail_current.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::readout {
namespace {

TEST(TailCurrent, LeavesOutTheEventsAndTheirSpikes) {
  SignalTable sampled;
  sampled.columns = {{"time", "s", {0.1, 0.2, 0.3, 0.4}}};
  EXPECT_EQ(in_tail(sampled, 0.1, {0.2}), (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(in_tail(sampled, 0.1, {0.19}), (std::vector<bool>{true, false, false, true}));
  EXPECT_EQ(in_tail(sampled, 0.1, {}), std::vector<bool>(4, true));
}

TEST(TailCurrent, IsTheRootMeanSquareOfTheRest) {
  EXPECT_DOUBLE_EQ(tail_rms({100, 3, 4}, {false, true, true}), std::sqrt(12.5));
  EXPECT_EQ(tail_rms({100}, {false}), 0);
}

} // namespace
} // namespace ionskin::readout
