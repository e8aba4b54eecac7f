// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::mechanics {
namespace {

ContactCells square_of_cells(std::size_t count) {
  ContactCells cells;
  for (std::size_t i = 0; i <= count; ++i) {
    cells.lines_x.push_back(-1 + 2.0 * static_cast<double>(i) / static_cast<double>(count));
  }
  cells.lines_y = cells.lines_x;
  cells.area.assign(count * count, std::pow(2.0 / static_cast<double>(count), 2));
  return cells;
}

/// Cell means of sqrt(a^2 - r^2) where the middle of the cell is inside: less covered cells do not
/// touch in a contact problem on cells.
std::vector<double> hertzian(const ContactCells& cells, double a) {
  constexpr int parts = 40;
  std::vector<double> field;
  for (std::size_t j = 0; j < cells.rows(); ++j) {
    for (std::size_t i = 0; i < cells.columns(); ++i) {
      double sum = 0;
      for (int p = 0; p < parts * parts; ++p) {
        const double s = (p % parts + 0.5) / parts, t = (p / parts + 0.5) / parts;
        const double x = cells.lines_x[i] + s * (cells.lines_x[i + 1] - cells.lines_x[i]);
        const double y = cells.lines_y[j] + t * (cells.lines_y[j + 1] - cells.lines_y[j]);
        sum += std::sqrt(std::max(0.0, a * a - x * x - y * y));
      }
      const double x = (cells.lines_x[i] + cells.lines_x[i + 1]) / 2;
      const double y = (cells.lines_y[j] + cells.lines_y[j + 1]) / 2;
      field.push_back(std::hypot(x, y) < a ? sum / (parts * parts) : 0.0);
    }
  }
  return field;
}

TEST(CoveredArea, OfACircleIsNear) {
  const ContactCells cells = square_of_cells(16);
  for (const double a : {0.66, 0.7, 0.74, 0.78, 0.82, 0.86}) {
    const double exact = std::numbers::pi * a * a;
    EXPECT_NEAR(covered_area(cells.grid(), hertzian(cells, a)), exact, 0.035 * exact) << a;
  }
}

TEST(CoveredArea, FindsStraightBordersWithinCells) {
  ContactCells cells = square_of_cells(16);
  cells.lines_y = {0, 1};
  cells.area.assign(cells.columns(), 2.0 / static_cast<double>(cells.columns()));
  for (const double a : {0.7, 0.73, 0.76, 0.79}) {
    std::vector<double> field(cells.columns(), 0.0);
    for (std::size_t i = 0; i < field.size(); ++i) {
      // Primitive of sqrt(a^2 - x^2).
      const auto primitive = [&](double at) {
        const double x = std::clamp(at, -a, a);
        return (x * std::sqrt(std::max(0.0, a * a - x * x)) + a * a * std::asin(x / a)) / 2;
      };
      if (std::abs(cells.lines_x[i] + cells.lines_x[i + 1]) / 2 < a) {
        field[i] = primitive(cells.lines_x[i + 1]) - primitive(cells.lines_x[i]);
      }
    }
    EXPECT_NEAR(covered_area(cells.grid(), field), 2 * a, 2 * 0.15 * 0.125)
        << a; // cells are 0.125 wide
  }
}

TEST(CoveredArea, EndsWithTheCells) {
  const ContactCells cells = square_of_cells(5);
  EXPECT_NEAR(covered_area(cells.grid(), std::vector<double>(25, 3.0)), 4, 1e-14);
  EXPECT_EQ(covered_area(cells.grid(), std::vector<double>(25, 0.0)), 0.0);
}

TEST(BorderArea, IsHalfOfTheLongerRowOfCellsAlongTheBorder) {
  const ContactCells cells = square_of_cells(10);
  std::vector<double> field(100, 0.0);
  field[44] = field[45] = 1; // six cells around them, of 0.04 each
  EXPECT_NEAR(border_area(cells.grid(), field), 6 * 0.04 / 2, 1e-12);
  std::fill(field.begin(), field.begin() + 50, 1.0); // one straight border, and none at the rim
  EXPECT_NEAR(border_area(cells.grid(), field), 10 * 0.04 / 2, 1e-12);
  std::ranges::fill(field, 1.0);
  EXPECT_EQ(border_area(cells.grid(), field), 0);
}

} // namespace
} // namespace ionskin::mechanics
