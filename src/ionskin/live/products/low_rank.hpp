// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::live {

/// A matrix as a sum of products of a column and a row.
struct LowRank {
  std::size_t rank = 0;
  std::vector<float> columns; ///< [rank][rows]
  std::vector<float> rows;    ///< [rank][columns]
};

/// Adaptive cross approximation with full pivoting (Bebendorf 2000, doi 10.1007/PL00005410): takes
/// away the cross of the largest entry until none above the tolerance is left.
/// @param matrix [column][row]
LowRank low_rank(std::vector<double> matrix, std::size_t rows, double tolerance);

} // namespace ionskin::live
