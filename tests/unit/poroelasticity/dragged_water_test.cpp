// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/dragged_water.hpp"

#include <gtest/gtest.h>

namespace ionskin::poroelasticity {
namespace {

constexpr double thickness = 2e-4, volume = 4e-5;
const std::vector<double> levels{0.0, 1e-6, 1e-4, 1.99e-4, thickness};
/// Water that is moved from the bottom to the top, none lost [mol/m2].
const std::vector<double> moved{-3e-6, -1e-6, 0.0, 1e-6, 3e-6};

WaterProperties properties() {
  WaterProperties water;
  water.mobility = 1e-18;
  water.consolidation_coefficient = 4e-10;
  return water;
}

DraggedWater water_between(double bottom, double top) {
  return {properties(), volume, wall_clustered_nodes(thickness, 12), {bottom, top}, levels};
}

/// A time after the cations have moved at once.
Outflow left_after(DraggedWater& water, double time) {
  PressureState there, end;
  water.step(water.rest(), 1e-9, moved, there);
  water.step(there, time, moved, end);
  return water.left();
}

TEST(DraggedWater, LeavesThroughOpenWallsAsTheMomentOfTheCationsTells) {
  DraggedWater water = water_between(open_wall, open_wall);
  const Outflow left = left_after(water, 1e4);
  double moment = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    moment += volume * levels[k] / thickness * moved[k];
  }
  EXPECT_NEAR(left.top, moment, 1e-9 * moment);
  EXPECT_NEAR(left.bottom, -moment, 1e-9 * moment);
  EXPECT_NEAR(water.pressure_difference(), 0.0, 1e-3);
}

TEST(DraggedWater, StaysBetweenSealedWallsAndLiftsThePressure) {
  DraggedWater water = water_between(sealed_wall, sealed_wall);
  const Outflow left = left_after(water, 1.0);
  EXPECT_EQ(left.top, 0.0);
  EXPECT_EQ(left.bottom, 0.0);
  EXPECT_GT(water.pressure_difference(), 0.0);
}

TEST(DraggedWater, ComesBackThroughTheOnlyOpenWall) {
  DraggedWater water = water_between(sealed_wall, open_wall);
  EXPECT_GT(left_after(water, 1.0).top, 1e-12);
  const Outflow left = left_after(water, 1e4);
  EXPECT_NEAR(left.top, 0.0, 1e-18);
  EXPECT_EQ(left.bottom, 0.0);
}

TEST(DraggedWater, IonsAtRestDragNone) {
  DraggedWater water = water_between(open_wall, open_wall);
  PressureState end;
  water.step(water.rest(), 1.0, {}, end);
  EXPECT_EQ(water.left().top, 0.0);
}

TEST(DraggedWater, OutflowIsWhatTheContentLost) {
  const std::vector<double> nodes{0.0, 0.25, 0.5}, growth{-1.0, -2.0, -3.0};
  const Outflow both = outflow(nodes, {open_wall, open_wall}, growth);
  EXPECT_DOUBLE_EQ(both.top, 4.0);
  EXPECT_DOUBLE_EQ(both.bottom, 2.0);
  EXPECT_DOUBLE_EQ(outflow(nodes, {open_wall, sealed_wall}, growth).bottom, 6.0);
  EXPECT_EQ(outflow(nodes, {open_wall, sealed_wall}, growth).top, 0.0);
}

} // namespace
} // namespace ionskin::poroelasticity
