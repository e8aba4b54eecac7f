// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/products/low_rank.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {

LowRank low_rank(std::vector<double> matrix, std::size_t rows, double tolerance) {
  LowRank result;
  const std::size_t columns = rows > 0 ? matrix.size() / rows : 0;
  for (; result.rank < std::min(rows, columns); ++result.rank) {
    const auto largest =
        std::ranges::max_element(matrix, {}, [](double value) { return std::abs(value); });
    if (!(std::abs(*largest) > tolerance)) {
      break;
    }
    const auto at = static_cast<std::size_t>(largest - matrix.begin());
    const double pivot = *largest;
    const std::vector<double> column(&matrix[at / rows * rows], &matrix[at / rows * rows] + rows);
    result.columns.insert(result.columns.end(), column.begin(), column.end());
    for (std::size_t j = 0; j < columns; ++j) {
      double* own = &matrix[j * rows];
      const double factor = own[at % rows] / pivot;
      result.rows.push_back(static_cast<float>(factor));
      for (std::size_t i = 0; i < rows; ++i) {
        own[i] -= factor * column[i];
      }
    }
  }
  return result;
}

} // namespace ionskin::live
