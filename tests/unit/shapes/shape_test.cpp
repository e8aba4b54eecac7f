// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::shapes {
namespace {

const HeightMap wedge{{-2e-3, 0, 2e-3}, {-2e-3, 2e-3}, {2e-6, 1e-6, 2e-6, 2e-6, 1e-6, 2e-6}};
const HeightMap nothing;

/// A value for every parameter of every shape, all rounder than flat.
laws::LawValues some_values() {
  laws::LawValues result;
  for (const ShapeRow& row : shapes()) {
    for (const laws::LawParameter& parameter : row.parameters) {
      result[std::string(parameter.name)] = 0.5e-3;
    }
  }
  return result;
}

TEST(Shape, RowSaysWhatItsShapeIs) {
  ASSERT_EQ(shapes().front().name, "flat");
  for (const ShapeRow& row : shapes()) {
    const auto made = shape(row.name, some_values());
    EXPECT_FALSE(row.meaning.empty());
    EXPECT_EQ(made->whole_plan().has_value(), row.has_whole_plan) << row.name;
    for (const laws::LawParameter& parameter : row.parameters) {
      EXPECT_LT(parameter.lowest, parameter.highest) << parameter.name;
      EXPECT_FALSE(parameter.help.empty()) << parameter.name;
    }
  }
}

TEST(Shape, HeightsCountFromTheLowestAndGrowOutsideThePartThatTouchesAtOnce) {
  for (const ShapeRow& row : shapes()) {
    const Plan plan{{1e-3, 1e-3}, wedge};
    const auto made = shape(row.name, some_values());
    const auto flat = made->flat_half_size(plan);
    double least = std::numeric_limits<double>::infinity();
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const double x = 0.125e-3 * i, y = 0.125e-3 * j;
        const double gap = made->height(plan, x, y) - made->lowest(plan);
        least = std::min(least, gap);
        EXPECT_GE(gap, 0) << row.name;
        if (made->symmetric(plan)[0]) {
          EXPECT_DOUBLE_EQ(made->height(plan, -x, y), made->height(plan, x, y)) << row.name;
        }
        if (std::abs(x) <= flat[0] && std::abs(y) <= flat[1]) {
          EXPECT_EQ(gap, 0) << row.name;
        }
      }
    }
    EXPECT_EQ(least, 0) << row.name;
    EXPECT_EQ(made->sharp(), flat[0] == plan.size[0] / 2 && flat[1] == plan.size[1] / 2);
  }
}

TEST(Shape, AHarderPressNeverTouchesLess) {
  for (const ShapeRow& row : shapes()) {
    const Plan plan{{1e-3, 1e-3}, wedge};
    const auto made = shape(row.name, some_values());
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_LE(made->border(plan, {1e-7, 0, 1e8, 1e-3}, d),
                made->border(plan, {2e-7, 0, 1e8, 1e-3}, d))
          << row.name;
      EXPECT_LE(made->border(plan, {0, 1e-3, 1e8, 1e-3}, d),
                made->border(plan, {0, 2e-3, 1e8, 1e-3}, d))
          << row.name;
    }
  }
}

TEST(Shape, OfRoundedEdgesTouchesAllOfThemUnderALargeForceAlone) {
  const auto rounded = shape("flat", {{"edge_radius", 0.2e-3}});
  const Plan plan{{1e-3, 2e-3}, wedge};
  const auto border = [&](double force) { return rounded->border(plan, {0, force, 1e8, 1e-3}, 0); };
  // 1 mN pushes a circle of 0.3 mm by 17 nm into a half-space.
  EXPECT_NEAR(border(1e-3), std::sqrt(6 * 0.2e-3 * 1e-3 / (2 * 0.3e-3 * 1e8)), 1e-9);
  EXPECT_EQ(border(10), 0.2e-3);
  EXPECT_EQ(shape("flat", {{"edge_radius", 0.5e-3}})->border(plan, {0, 1e-3, 1e8, 1e-3}, 0),
            0.5e-3);
}

TEST(Shape, TellsWhatDoesNotGoTogether) {
  const Plan wide{{2e-3, 2e-3}, wedge};
  EXPECT_EQ(shape("sphere", {{"radius", 0.5e-3}})->misfits(wide).size(), 2u);
  EXPECT_EQ(shape("cylinder", {{"radius", 0.5e-3}})->misfits(wide).size(), 1u);
  EXPECT_EQ(shape("flat", {{"edge_radius", 1.1e-3}})->misfits(wide).size(), 1u);
  EXPECT_EQ(shape("profile", {})->misfits({{5e-3, 1e-3}, wedge}).size(), 1u);
  EXPECT_TRUE(shape("profile", {})->misfits(wide).empty());
}

TEST(Shape, NeedsNoParametersWithoutContact) {
  EXPECT_TRUE(shape("flat", {})->sharp());
  EXPECT_FALSE(shape("sphere", {})->sharp());
  EXPECT_EQ(shape("sphere", {})->flat_half_size({{1e-3, 1e-3}, nothing})[0], 0);
}

} // namespace
} // namespace ionskin::shapes
