// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/renumbered_pattern.hpp"

#include <algorithm>
#include <numeric>

namespace ionskin::linear_algebra {
namespace {

/// First place of each key among entries sorted by it, and the end.
std::vector<int> starts(const std::vector<int>& keys, int key_count) {
  std::vector<int> start(static_cast<std::size_t>(key_count) + 1);
  for (const int key : keys) {
    ++start[key + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  return start;
}

} // namespace

RenumberedPattern renumbered(const SymmetricPattern& pattern, const std::vector<int>& order) {
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[order[k]] = static_cast<int>(k);
  }
  std::vector<int> row, column;
  row.reserve(pattern.row.size());
  column.reserve(pattern.row.size());
  for (int j = 0; j < pattern.size; ++j) {
    for (int p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
      const auto [low, high] = std::minmax(number[j], number[pattern.row[p]]);
      column.push_back(low);
      row.push_back(high);
    }
  }
  // By rows first, so that they ascend in each column.
  std::vector<int> next = starts(row, pattern.size), by_row(row.size());
  for (std::size_t entry = 0; entry < row.size(); ++entry) {
    by_row[next[row[entry]]++] = static_cast<int>(entry);
  }
  RenumberedPattern result{{pattern.size, starts(column, pattern.size), {}}, {}};
  result.pattern.row.resize(row.size());
  result.source.resize(row.size());
  next = result.pattern.column_start;
  for (const int entry : by_row) {
    const int at = next[column[entry]]++;
    result.pattern.row[at] = row[entry];
    result.source[at] = entry;
  }
  return result;
}

} // namespace ionskin::linear_algebra
