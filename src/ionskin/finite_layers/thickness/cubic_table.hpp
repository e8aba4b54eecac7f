// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <utility>

namespace ionskin::finite_layers {

/// Table of four functions of one variable, sampled at equally spaced nodes and interpolated by a
/// cubic polynomial through the four nearest nodes.
class CubicTable {
public:
  using Values = Eigen::Array4d;

  CubicTable() = default;
  /// Makes the table of four functions.
  /// @param first position of the first node, in units of the variable
  /// @param step distance between nodes, in units of the variable
  /// @param values of the functions at all nodes, [function, node], with at least four nodes
  CubicTable(double first, double step, Eigen::Array4Xd values)
      : first_(first), inverse_step_(1 / step), values_(std::move(values)) {}

  /// True if the table was default-constructed and holds no values.
  bool empty() const { return values_.size() == 0; }
  /// Interpolates the four functions.
  /// @param place value of the variable, between the first and the last node
  Values at(double place) const {
    const double steps = (place - first_) * inverse_step_;
    const auto node =
        std::clamp(static_cast<Eigen::Index>(steps), Eigen::Index{1}, values_.cols() - 3);
    const double t = steps - static_cast<double>(node);
    return -t * (t - 1) * (t - 2) / 6 * values_.col(node - 1) +
           (t + 1) * (t - 1) * (t - 2) / 2 * values_.col(node) -
           (t + 1) * t * (t - 2) / 2 * values_.col(node + 1) +
           (t + 1) * t * (t - 1) / 6 * values_.col(node + 2);
  }

private:
  double first_ = 0, inverse_step_ = 0;
  Eigen::Array4Xd values_;
};

} // namespace ionskin::finite_layers
