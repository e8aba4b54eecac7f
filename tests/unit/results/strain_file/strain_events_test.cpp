// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/strain_file/strain_events.hpp"

#include "strain_example.hpp"

#include <gtest/gtest.h>

namespace ionskin::results {
namespace {

using history::CoreHistory;
using history::Frame;

// One column, two nodes with the same shear: the history of one number.
CoreHistory history_of(std::vector<double> time, const std::vector<double>& shear) {
  CoreHistory history;
  history.grid = {{0, 1e-3}, {0, 1e-3}, {0, 1e-4}};
  history.time = std::move(time);
  for (double value : shear) {
    history.shear().push_back(std::make_shared<history::StrainField>(2, value));
  }
  return history;
}

TEST(StrainEvents, TheFirstSampleIsAlwaysOne) {
  EXPECT_EQ(detect_events(history_of({3, 4}, {1, 1})), (std::vector<double>{3}));
}

TEST(StrainEvents, KinksAreEventsAndStraightPiecesAreNot) {
  EXPECT_EQ(detect_events(history_of({0, 1, 2, 3, 4, 5}, {0, 1, 2, 2, 2, 1})),
            (std::vector<double>{0, 2, 4}));
}

TEST(StrainEvents, JumpsBelowAThousandthOfTheLargestRateAreNoEvents) {
  EXPECT_EQ(detect_events(history_of({0, 1, 2, 3}, {0, 1, 2.0009, 3.0018})),
            (std::vector<double>{0}));
  EXPECT_EQ(detect_events(history_of({0, 1, 2, 3}, {0, 1, 2.0019, 3.0038})),
            (std::vector<double>{0, 1}));
}

TEST(StrainEvents, AShearThatOnlyMovesBetweenColumnsIsSeen) {
  CoreHistory history = example_history(Frame::skin);
  const auto field = [](history::StrainField values) {
    return std::make_shared<history::StrainField>(std::move(values));
  };
  history.time = {0, 1, 2};
  history.shear() = {field({1, 0, 0, 1, 0, 0}), field({0, 1, 0, 0, 1, 0}),
                     field({0, 0, 1, 0, 0, 1})};
  EXPECT_EQ(detect_events(history), (std::vector<double>{0, 1}));
}

TEST(StrainEvents, ASliderThatStartsUnderShearIsAnEventAndADetachedOneIsNot) {
  CoreHistory history = history_of({0, 1, 2}, {1, 1, 1});
  history.frame = Frame::slider;
  history.slider_x = {0, 0, 1e-3};
  EXPECT_EQ(detect_events(history), (std::vector<double>{0, 1}));
  CoreHistory detached = history_of({0, 1, 2}, {0, 0, 0});
  detached.frame = Frame::slider;
  detached.slider_x = {0, 0, 1e-3};
  EXPECT_EQ(detect_events(detached), (std::vector<double>{0}));
}

} // namespace
} // namespace ionskin::results
