// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <vector>

namespace ionskin::linear_algebra {

/// P A P^T of a pattern A, and where its entries stand there.
struct RenumberedPattern {
  SymmetricPattern pattern;
  std::vector<int> source; ///< entry of A, of each entry
};

/// @param order order[k] is the k-th unknown of the result
RenumberedPattern renumbered(const SymmetricPattern& pattern, const std::vector<int>& order);

} // namespace ionskin::linear_algebra
