// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/compliance_map.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

constexpr double negligible_mode = 1e-8; // over the norm of the mean

Eigen::Map<Eigen::VectorXd> entries(DenseMatrix& matrix) {
  return {matrix.values.data(), static_cast<Eigen::Index>(matrix.values.size())};
}

Eigen::Map<const Eigen::VectorXd> entries(const DenseMatrix& matrix) {
  return {matrix.values.data(), static_cast<Eigen::Index>(matrix.values.size())};
}

} // namespace

std::vector<double> node_weights(const NodeLines& lines, const std::array<double, 2>& place) {
  const auto along = [&](std::size_t axis) {
    const std::vector<double>& line = lines.at[axis];
    const EndCoordinate& coordinate = lines.coordinate[axis];
    std::vector<double> nodes;
    for (const double node : line) {
      nodes.push_back(coordinate.at(node));
    }
    const double nearest = std::clamp(place[axis], line.front(), line.back());
    return interpolation_weights(nodes, coordinate.at(nearest));
  };
  const std::vector<double> x = along(0), y = along(1);
  std::vector<double> weights;
  for (const double of_y : y) {
    for (const double of_x : x) {
      weights.push_back(of_x * of_y);
    }
  }
  return weights;
}

ComplianceMap::ComplianceMap(NodeLines lines, std::vector<DenseMatrix> nodes)
    : lines_(std::move(lines)), mean_(nodes.front().rows, nodes.front().columns) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  for (const DenseMatrix& node : nodes) {
    entries(mean_) += entries(node) / static_cast<double>(count);
  }
  Eigen::MatrixXd gram(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    entries(nodes[i]) -= entries(std::as_const(mean_));
    for (Eigen::Index j = 0; j <= i; ++j) {
      gram(i, j) = gram(j, i) = entries(nodes[i]).dot(entries(nodes[j]));
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(gram);
  const double scale = entries(mean_).norm();
  std::vector<Eigen::Index> large;
  for (Eigen::Index i = count; i-- > 0;) {
    if (modes.eigenvalues()[i] > std::pow(negligible_mode * scale, 2)) {
      large.push_back(i);
    }
  }
  amplitude_ = modes.eigenvectors()(Eigen::indexing::all, large);
  for (Eigen::Index mode = 0; mode < amplitude_.cols(); ++mode) {
    DenseMatrix& sum = modes_.emplace_back(mean_.rows, mean_.columns);
    for (Eigen::Index i = 0; i < count; ++i) {
      entries(sum) += amplitude_(i, mode) * entries(nodes[i]);
    }
  }
}

void ComplianceMap::at(const std::array<double, 2>& place, DenseMatrix& result) const {
  const std::vector<double> weights = node_weights(lines_, place);
  const Eigen::VectorXd amplitudes =
      amplitude_.transpose() *
      Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size()));
  result = mean_;
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
    entries(result) += amplitudes[static_cast<Eigen::Index>(mode)] * entries(modes_[mode]);
  }
}

} // namespace ionskin::mechanics
