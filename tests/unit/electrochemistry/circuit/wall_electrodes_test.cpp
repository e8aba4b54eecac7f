// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"

#include "ionskin/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::electrochemistry {
namespace {

/// Five columns, of which the third is shared.
WallElectrodes two_conductors() {
  return WallElectrodes({{{1, 1, 0.3, 0, 0}, std::nullopt}, {{0, 0, 0.7, 1, 1}, std::nullopt}});
}

TEST(WallElectrodes, PotentialsOfColumnsAndBack) {
  const WallElectrodes electrodes = two_conductors();
  std::vector<double> columns(5);
  electrodes.spread(std::vector{2.0, -1.0}, columns);
  EXPECT_THAT(columns, testing::ElementsAre(2, 2, testing::DoubleEq(0.6 - 0.7), -1, -1));
  const std::vector<double> back = electrodes.potentials(columns);
  EXPECT_NEAR(back[0], 2, 1e-15);
  EXPECT_NEAR(back[1], -1, 1e-15);
}

TEST(WallElectrodes, ASharedColumnGivesEachItsShareOfTheCharge) {
  EXPECT_THAT(two_conductors().sums(std::vector{1.0, 2.0, 10.0, 4.0, 5.0}),
              testing::ElementsAre(6, 16));
}

TEST(WallElectrodes, WhatIsAddedHasTheSums) {
  const WallElectrodes electrodes = two_conductors();
  std::vector<double> columns(5, 0.0);
  electrodes.add(std::vector{3.0, -2.0}, columns);
  const std::vector<double> sums = electrodes.sums(columns);
  EXPECT_NEAR(sums[0], 3, 1e-14);
  EXPECT_NEAR(sums[1], -2, 1e-14);
}

/// Three columns: two conductors above, one and a half columns each, one below.
TEST(WallElectrodes, BothWallsHaveFieldsOfTheirOwn) {
  const WallElectrodes electrodes({{{1, 0.5, 0}, std::nullopt, top_wall},
                                   {{0, 0.5, 1}, std::nullopt, top_wall},
                                   {{1, 1, 1}, std::nullopt, bottom_wall}});
  EXPECT_TRUE(electrodes.on_bottom());
  std::vector<double> walls(7, 9.0); // with one node between that is none of a wall
  electrodes.spread(std::vector{1.0, 3.0, -5.0}, walls);
  EXPECT_THAT(walls, testing::ElementsAre(-5, -5, -5, 9, 1, 2, 3));
  const std::vector<double> back = electrodes.potentials(walls);
  EXPECT_NEAR(back[0], 1, 1e-15);
  EXPECT_NEAR(back[1], 3, 1e-15);
  EXPECT_NEAR(back[2], -5, 1e-15);
  EXPECT_THAT(electrodes.sums(walls), testing::ElementsAre(2, 4, -15));
}

TEST(WallElectrodes, RefusesTwoInOneColumn) {
  EXPECT_THROW(WallElectrodes({{{1, 0.5}, std::nullopt}, {{1, 0.5}, std::nullopt}}), InternalError);
}

TEST(ElectrodeStage, InfiniteConductanceHolds) {
  const ElectrodeStage stage{{0, 0}, {std::numeric_limits<double>::infinity(), 1e300}};
  EXPECT_TRUE(stage.holds(0));
  EXPECT_FALSE(stage.holds(1));
}

} // namespace
} // namespace ionskin::electrochemistry
