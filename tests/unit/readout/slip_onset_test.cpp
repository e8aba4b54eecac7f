// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/slip_onset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::readout {
namespace {

TEST(SlipState, TellsDetachedStickPartialAndFullSlip) {
  EXPECT_EQ(slip_state(0, 1), SlipState::detached);
  EXPECT_EQ(slip_state(std::nan(""), 1), SlipState::detached);
  EXPECT_EQ(slip_state(1e-6, 1), SlipState::stick);
  EXPECT_EQ(slip_state(1e-6, 0.96), SlipState::stick);
  EXPECT_EQ(slip_state(1e-6, 0.94), SlipState::partial_slip);
  EXPECT_EQ(slip_state(1e-6, 0.02), SlipState::partial_slip);
  EXPECT_EQ(slip_state(1e-6, 0.005), SlipState::full_slip);
}

/// A sphere dragged by Q under N: the stuck radius is (1 - Q/(mu N))^(1/3) of the contact's
/// (Cattaneo 1938; Mindlin 1949, doi 10.1115/1.4009973), the share its square. Q grows to mu N from
/// 1 s to 2 s.
TEST(SlipOnset, IsThatOfCattaneoAndMindlin) {
  std::vector<double> time, share;
  for (int i = 0; i <= 4000; ++i) {
    time.push_back(i * 1e-3);
    const double load = std::clamp(time.back() - 1, 0.0, 1.0);
    share.push_back(std::pow(1 - load, 2.0 / 3.0));
  }
  const std::vector<double> area(time.size(), 1e-6);
  const auto onset = find_slip_onset(time, area, share, {1, 3});
  ASSERT_TRUE(onset && onset->full_slip);
  EXPECT_DOUBLE_EQ(onset->begin, 1);
  EXPECT_NEAR(onset->micro_slip - 1, 1 - std::pow(0.95, 1.5), 1e-6);
  EXPECT_NEAR(*onset->full_slip - 1, 1 - std::pow(0.01, 1.5), 1e-3);
  EXPECT_NEAR(onset->micro_slip_step, 1e-3, 1e-12);
}

TEST(SlipOnset, IsTakenFromWhatSticksAgainWhenTheSlideBegins) {
  // Pressed with half of it slipping; 0.7 of it sticks when the slide begins at 2 s.
  const std::vector<double> time{0, 1, 2, 3, 4, 5, 6}, area{0, 1, 1, 1, 1, 1, 1},
      share{0, 0.4, 0.5, 0.7, 0.6, 0.1, 0};
  const auto onset = find_slip_onset(time, area, share, {2, 6});
  ASSERT_TRUE(onset && onset->full_slip);
  EXPECT_DOUBLE_EQ(onset->begin, 2);
  EXPECT_NEAR(onset->micro_slip, 3.5, 1e-12);
  EXPECT_NEAR(*onset->full_slip, 5.9, 1e-12);
  EXPECT_DOUBLE_EQ(onset->full_slip_step, 1);
}

TEST(SlipOnset, EndsWithTheSlide) {
  const std::vector<double> time{0, 1, 2, 3}, area{1, 1, 1, 1}, share{1, 0.6, 0.3, 0};
  const auto onset = find_slip_onset(time, area, share, {0, 2});
  ASSERT_TRUE(onset);
  EXPECT_FALSE(onset->full_slip);
  EXPECT_EQ(onset->full_slip_step, 0);
}

TEST(SlipOnset, BeginsWhereASlideLands) {
  const std::vector<double> time{0, 1, 2, 3, 4}, area{0, 0, 1, 1, 1}, share{0, 0, 1, 0.5, 0};
  const auto onset = find_slip_onset(time, area, share, {0, 4});
  ASSERT_TRUE(onset);
  EXPECT_EQ(onset->begin, 2);
  EXPECT_NEAR(onset->micro_slip, 2.1, 1e-12);
}

TEST(SlipOnset, IsNoneWhereNothingSticksOrNothingSlips) {
  const std::vector<double> time{0, 1, 2}, area{1, 1, 1};
  EXPECT_FALSE(find_slip_onset(time, area, {0, 0, 0}, {0, 2}));
  EXPECT_FALSE(find_slip_onset(time, area, {0.04, 0.02, 0}, {0, 2}));
  EXPECT_FALSE(find_slip_onset(time, area, {1, 0.97, 0.96}, {0, 2}));
  EXPECT_FALSE(find_slip_onset(time, {0, 0, 0}, {0, 0, 0}, {0, 2}));
}

} // namespace
} // namespace ionskin::readout
