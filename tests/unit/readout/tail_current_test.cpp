// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/tail_current.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::readout {
namespace {

TEST(TailCurrent, LeavesOutTheEventsAndTheirSpikes) {
  SignalTable sampled;
  sampled.columns = {{"time", "s", {0.1, 0.2, 0.3, 0.4}}};
  const double relaxation = 0.00625; // spikes of 50 ms
  EXPECT_EQ(in_tail(sampled, 0.1, {0.2}, relaxation), (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(in_tail(sampled, 0.1, {0.19}, relaxation),
            (std::vector<bool>{true, false, false, true}));
  EXPECT_EQ(in_tail(sampled, 0.1, {}, relaxation), std::vector<bool>(4, true));
}

TEST(TailCurrent, SpikesAreAsLongAsTheCoreRelaxes) {
  SignalTable sampled;
  sampled.columns = {{"time", "s", {0.1, 0.2, 0.3, 0.4, 0.5}}};
  // Spikes of 0.16 s hide two more intervals, those of a fast core none.
  EXPECT_EQ(in_tail(sampled, 0.1, {0.05}, 0.02),
            (std::vector<bool>{false, false, false, true, true}));
  EXPECT_EQ(in_tail(sampled, 0.1, {0.05}, 1e-6),
            (std::vector<bool>{false, true, true, true, true}));
  // However slow, they leave half of the longest rest.
  EXPECT_EQ(in_tail(sampled, 0.1, {0.05, 0.45}, 10),
            (std::vector<bool>{false, false, false, true, false}));
}

TEST(TailCurrent, IsTheRootMeanSquareOfTheRest) {
  EXPECT_DOUBLE_EQ(tail_rms({100, 3, 4}, {false, true, true}), std::sqrt(12.5));
  EXPECT_EQ(tail_rms({100}, {false}), 0);
}

} // namespace
} // namespace ionskin::readout
