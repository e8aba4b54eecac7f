// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/merged_cells.hpp"

#include "ionskin/history/shear_statistics.hpp"

#include <gtest/gtest.h>

namespace ionskin::history {
namespace {

TEST(MergedCells, KeepIntegralsMirrorImagesAndSharedFields) {
  CoreHistory history;
  history.length = 5;
  history.width = 6;
  history.grid = {{0, 1, 3, 5}, {0, 1, 2, 3, 4, 5, 6}, {0, 1}};
  StrainField field(history.grid.values());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::size_t row = (i / 3) % 6, mirrored = std::min(row, 5 - row);
    field[i] = 1 + static_cast<double>(mirrored * 3 + i % 3);
  }
  const auto shared = std::make_shared<const StrainField>(field);
  history.time = {0, 1};
  history.shear() = {shared, shared};

  const CoreHistory merged = merge_cells(history);
  EXPECT_EQ(merged.grid.x_edges, (std::vector<double>{0, 5}));
  EXPECT_EQ(merged.grid.y_edges, (std::vector<double>{0, 2, 4, 6}));
  EXPECT_EQ(merged.shear()[0], merged.shear()[1]);
  EXPECT_DOUBLE_EQ(shear_integral(merged, 0.5), shear_integral(history, 0.5));
  EXPECT_DOUBLE_EQ((*merged.shear()[0])[0], (*merged.shear()[0])[2]);
}

} // namespace
} // namespace ionskin::history
