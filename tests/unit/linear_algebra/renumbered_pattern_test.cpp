// SPDX-License-Identifier: Apache-2.0
#include "grid_graph.hpp"
#include "ionskin/linear_algebra/renumbered_pattern.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace ionskin::linear_algebra {
namespace {

using Entry = std::pair<int, int>; ///< larger and smaller index

std::vector<Entry> entries(const SymmetricPattern& pattern) {
  std::vector<Entry> result;
  for (int j = 0; j < pattern.size; ++j) {
    for (int p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
      result.emplace_back(pattern.row[p], j);
    }
  }
  return result;
}

TEST(RenumberedPattern, holds_the_entries_of_the_renumbered_matrix_in_ascending_rows) {
  const SymmetricPattern grid = grid_graph(4);
  std::vector<int> order;
  for (int k = 0; k < grid.size; ++k) {
    order.push_back(13 * k % grid.size); // 13 and 64 have no common divisor
  }
  const RenumberedPattern result = renumbered(grid, order);
  const std::vector<Entry> before = entries(grid), after = entries(result.pattern);
  ASSERT_EQ(after.size(), before.size());
  ASSERT_EQ(result.source.size(), before.size());
  EXPECT_EQ(std::set(result.source.begin(), result.source.end()).size(), before.size());
  for (std::size_t entry = 0; entry < after.size(); ++entry) {
    const auto [row, column] = after[entry];
    const Entry of_grid = std::minmax(order[row], order[column], std::greater{});
    EXPECT_EQ(of_grid, before[result.source[entry]]);
    EXPECT_GE(row, column);
    if (entry > 0 && after[entry - 1].second == column) {
      EXPECT_LT(after[entry - 1].first, row);
    }
  }
}

} // namespace
} // namespace ionskin::linear_algebra
