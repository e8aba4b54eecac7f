// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Lines of interpolation nodes along x and y; the nodes are where they cross, x fastest.
struct NodeLines {
  std::array<std::vector<double>, 2> at; ///< ascending [m]
  std::array<EndCoordinate, 2> coordinate{};
  std::array<bool, 2> in_pairs{}; ///< whether they mirror each other in the skin's middle
};

/// By which the values at the nodes give that at a place: products of Lagrange polynomials in
/// the coordinates. Beside the rectangle of the nodes it is that of the nearest place in it.
std::vector<double> node_weights(const NodeLines& lines, const std::array<double, 2>& place);

/// The compliance of the contact cells over the slider's places. Along a slide it varies by less
/// than a per cent, so that some of its principal modes over the nodes stand for all of them: what
/// they leave is below 1e-8 of its norm.
class ComplianceMap {
public:
  /// @param nodes one compliance per crossing of the lines, x fastest [m/N]
  ComplianceMap(NodeLines lines, std::vector<linear_algebra::DenseMatrix> nodes);

  /// @param result resized [m/N]
  void at(const std::array<double, 2>& place, linear_algebra::DenseMatrix& result) const;
  const NodeLines& lines() const { return lines_; }
  std::size_t modes() const { return modes_.size(); }

private:
  NodeLines lines_;
  linear_algebra::DenseMatrix mean_;
  std::vector<linear_algebra::DenseMatrix> modes_;
  Eigen::MatrixXd amplitude_; ///< [nodes, modes]
};

} // namespace ionskin::mechanics
