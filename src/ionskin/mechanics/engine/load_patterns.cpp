// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/load_patterns.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

LoadPatterns load_patterns(const std::vector<CellVector>& loads, double negligible) {
  const auto count = static_cast<Eigen::Index>(loads.size());
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(loads.front().size()), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CellVector& load = loads[static_cast<std::size_t>(i)];
    columns.col(i) = Eigen::Map<const Eigen::VectorXd>(load.data(), columns.rows());
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns);
  const auto& triangle = decomposition.matrixQR();
  const Eigen::Index most = std::min(columns.rows(), count);
  Eigen::Index rank = 0;
  // What is no number is not negligible.
  while (rank < most && !(std::abs(triangle(rank, rank)) <= negligible)) {
    ++rank;
  }
  Eigen::MatrixXd rest = triangle.topRightCorner(rank, count - rank);
  if (rest.size() > 0) { // Eigen takes the address of the first of no values
    triangle.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solveInPlace(rest);
  }
  const auto& place = decomposition.colsPermutation().indices();
  LoadPatterns patterns{
      {}, linear_algebra::DenseMatrix(static_cast<int>(rank), static_cast<int>(count))};
  for (Eigen::Index i = 0; i < count; ++i) {
    if (i < rank) {
      patterns.chosen.push_back(static_cast<std::size_t>(place[i]));
      patterns.share(static_cast<int>(i), place[i]) = 1;
    }
    for (Eigen::Index j = 0; i >= rank && j < rank; ++j) {
      patterns.share(static_cast<int>(j), place[i]) = rest(j, i - rank);
    }
  }
  return patterns;
}

} // namespace ionskin::mechanics
