// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/top_electrodes.hpp"

#include "ionskin/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::electrochemistry {
namespace {

/// Five columns, of which the third is shared.
TopElectrodes two_conductors() {
  return TopElectrodes({{{1, 1, 0.3, 0, 0}, std::nullopt}, {{0, 0, 0.7, 1, 1}, std::nullopt}});
}

TEST(TopElectrodes, PotentialsOfColumnsAndBack) {
  const TopElectrodes electrodes = two_conductors();
  std::vector<double> columns(5);
  electrodes.spread(std::vector{2.0, -1.0}, columns);
  EXPECT_THAT(columns, testing::ElementsAre(2, 2, testing::DoubleEq(0.6 - 0.7), -1, -1));
  const std::vector<double> back = electrodes.potentials(columns);
  EXPECT_NEAR(back[0], 2, 1e-15);
  EXPECT_NEAR(back[1], -1, 1e-15);
}

TEST(TopElectrodes, ASharedColumnGivesEachItsShareOfTheCharge) {
  EXPECT_THAT(two_conductors().sums(std::vector{1.0, 2.0, 10.0, 4.0, 5.0}),
              testing::ElementsAre(6, 16));
}

TEST(TopElectrodes, WhatIsAddedHasTheSums) {
  const TopElectrodes electrodes = two_conductors();
  std::vector<double> columns(5, 0.0);
  electrodes.add(std::vector{3.0, -2.0}, columns);
  const std::vector<double> sums = electrodes.sums(columns);
  EXPECT_NEAR(sums[0], 3, 1e-14);
  EXPECT_NEAR(sums[1], -2, 1e-14);
}

TEST(TopElectrodes, RefusesTwoInOneColumn) {
  EXPECT_THROW(TopElectrodes({{{1, 0.5}, std::nullopt}, {{1, 0.5}, std::nullopt}}), InternalError);
}

TEST(ElectrodeStage, InfiniteConductanceHolds) {
  const ElectrodeStage stage{{0, 0}, {std::numeric_limits<double>::infinity(), 1e300}};
  EXPECT_TRUE(stage.holds(0));
  EXPECT_FALSE(stage.holds(1));
}

} // namespace
} // namespace ionskin::electrochemistry
