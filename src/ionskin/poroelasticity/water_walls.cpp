// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/water_walls.hpp"

namespace ionskin::poroelasticity {
namespace {

double exchange(WaterWall wall, double conductance, double mobility) {
  switch (wall) {
  case WaterWall::open:
    return open_wall;
  case WaterWall::permeable:
    return conductance / mobility;
  case WaterWall::sealed:
    break;
  }
  return sealed_wall;
}

} // namespace

double WaterWalls::share_of_top(double height, double thickness) const {
  if (top == sealed_wall || bottom == sealed_wall) {
    return top == sealed_wall ? 0.0 : 1.0;
  }
  return (1 / bottom + height) * slope_of_share(thickness);
}

double WaterWalls::slope_of_share(double thickness) const {
  return top == sealed_wall || bottom == sealed_wall ? 0.0 : 1 / (1 / bottom + thickness + 1 / top);
}

WaterWalls water_walls(const Water& water, double mobility) {
  return {exchange(water.bottom_wall, water.bottom_conductance, mobility),
          exchange(water.top_wall, water.top_conductance, mobility)};
}

} // namespace ionskin::poroelasticity
