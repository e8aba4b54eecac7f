// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Low-rank approximation of a matrix: sum over `rank` of a column times a row.
struct LowRank {
  std::size_t rank = 0;
  std::vector<float> columns; ///< [rank][rows]
  std::vector<float> rows;    ///< [rank][columns]
};

/// Approximates a matrix by adaptive cross approximation with full pivoting (Bebendorf 2000, doi
/// 10.1007/PL00005410): subtracts the cross of the largest entry until no entry exceeds the
/// tolerance.
/// @param matrix [column][row]
/// @param rows number of rows
/// @param tolerance largest magnitude of a remaining entry, in the unit of the matrix
LowRank low_rank(std::vector<double> matrix, std::size_t rows, double tolerance);

} // namespace ionskin::live
