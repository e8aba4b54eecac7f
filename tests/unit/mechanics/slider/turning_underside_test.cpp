// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/turning_underside.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace ionskin::mechanics {
namespace {

/// Cells of 0.1 mm over 2 mm x 2 mm.
ContactCells even_cells() {
  ContactCells cells;
  for (int i = -10; i <= 10; ++i) {
    cells.lines_x.push_back(1e-4 * i);
    cells.lines_y.push_back(1e-4 * i);
  }
  cells.area.assign(400, 1e-8);
  return cells;
}

TEST(TurningUnderside, CellsOfATurnedBlockAreCoveredOrNot) {
  Slider slider;
  slider.size = {1.4e-3, 0.8e-3};
  slider.changing.yaw = true;
  const ContactCells cells = even_cells();
  const TurningUnderside underside(slider, cells);
  for (const double yaw : {0.0, 0.3, 0.8, 2.0}) {
    const auto gap = underside.gap({0, 0, yaw});
    double covered = 0;
    for (const double at : gap) {
      EXPECT_TRUE(at == 0 || at > 0.1) << at;
      covered += at == 0 ? 1e-8 : 0;
    }
    constexpr double outline = 2 * (1.4e-3 + 0.8e-3), cell = 1e-4;
    EXPECT_NEAR(covered, 1.4e-3 * 0.8e-3, outline * cell / 4) << yaw;
  }
}

TEST(TurningUnderside, TurnsAndTiltsAboutItsCentre) {
  Slider slider;
  slider.size = {2e-3, 2e-3};
  const ContactCells cells = even_cells();
  const TurningUnderside underside(slider, cells);
  const auto turn = underside.turn(0.01);
  const std::size_t cell = 15 + 20 * 2; // at x = 0.55 mm, y = -0.75 mm
  EXPECT_NEAR(turn[cell][0], 0.75e-5, 1e-12);
  EXPECT_NEAR(turn[cell][1], 0.55e-5, 1e-12);
  const shapes::Pose pose{0.01, 0.02, 0};
  const auto gap = underside.gap(pose); // above the corner at x = 1 mm, y = -1 mm
  const double expected = (1e-3 - 0.55e-3) * std::tan(0.02) + (1e-3 - 0.75e-3) * std::tan(0.01);
  EXPECT_NEAR(gap[cell], expected, 1e-12);
  const auto place = underside.place({0.01, 0.02, 0.01}, gap);
  EXPECT_EQ(place[cell][0], -gap[cell]);
  EXPECT_EQ(place[cell][1], turn[cell][0]);
}

} // namespace
} // namespace ionskin::mechanics
