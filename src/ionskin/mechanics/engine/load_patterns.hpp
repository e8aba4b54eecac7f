// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Loads of which all the others are combinations.
struct LoadPatterns {
  std::vector<std::size_t> chosen;   ///< indices of the loads
  linear_algebra::DenseMatrix share; ///< of the chosen ones in every load; [chosen, loads]
};

/// As few of them as leave no more than `negligible` of each load: by a QR decomposition with
/// column pivoting (Golub and Van Loan, Matrix Computations, 2013, section 5.4). A sliding slider
/// passes hundreds of states, which differ in some ten ways.
/// @param loads all of the same length [N]
/// @param negligible Euclidean norm [N]
LoadPatterns load_patterns(const std::vector<CellVector>& loads, double negligible);

} // namespace ionskin::mechanics
