// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/line_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ionskin::poroelasticity {
namespace {

/// Largest departure of from_modes * to_modes from the unit matrix.
double departure_from_identity(const LineModes& modes, std::size_t first, std::size_t last) {
  double worst = 0;
  for (std::size_t i = first; i < last; ++i) {
    for (std::size_t j = first; j < last; ++j) {
      double sum = i == j ? -1 : 0;
      for (std::size_t m = 0; m < modes.size; ++m) {
        sum += modes.from_modes[i * modes.size + m] * modes.to_modes[m * modes.size + j];
      }
      worst = std::max(worst, std::abs(sum));
    }
  }
  return worst;
}

TEST(LineModes, CosinesInvertEachOther) {
  const LineModes modes = cosine_modes(11, 0.2e-3);
  EXPECT_LT(departure_from_identity(modes, 0, 11), 1e-13);
  EXPECT_EQ(modes.curvature.front(), 0.0);
  // Long waves have the eigenvalues of the continuous problem.
  EXPECT_NEAR(modes.curvature[1], std::pow(std::numbers::pi / 2.2e-3, 2),
              0.01 * modes.curvature[1]);
}

TEST(LineModes, WallModesInvertEachOtherAndOpenWallsAreTheirOwn) {
  const auto nodes = wall_clustered_nodes(1.0, 8);
  const LineModes sealed = wall_modes(nodes, {sealed_wall, sealed_wall});
  EXPECT_LT(departure_from_identity(sealed, 0, 17), 1e-12);
  EXPECT_EQ(sealed.curvature.front(), 0.0);
  EXPECT_NEAR(sealed.curvature[1], std::pow(std::numbers::pi, 2), 1e-3);
  const LineModes drained = wall_modes(nodes, {sealed_wall, open_wall});
  EXPECT_LT(departure_from_identity(drained, 0, 17), 1e-12);
  EXPECT_TRUE(std::isinf(drained.curvature[16]));
  for (std::size_t m = 0; m < 17; ++m) {
    EXPECT_EQ(drained.from_modes[16 * 17 + m], m == 16 ? 1.0 : 0.0);
  }
  EXPECT_NEAR(drained.curvature[0], std::pow(std::numbers::pi / 2, 2), 1e-4);
}

} // namespace
} // namespace ionskin::poroelasticity
