// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/depth_strain.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// Table of `depth_strain` at several levels over the wave number, interpolated by cubics in the
/// logarithm of the wave number. The table of one level fits the first-level cache of a processor,
/// so that a look-up is cheaper than storing the values of all modes.
class DepthTable {
public:
  using Values = Eigen::Array<double, 8, 1>; ///< members of `DepthStrain` in their order [1/Pa]

  /// Tabulates the strain.
  /// @param layers bottom to top
  /// @param longest smallest wave number of the table, below which tractions act like a uniform
  /// load [1/m]
  /// @param cutoffs for each level, wave number beyond which its strain is not needed [1/m]
  DepthTable(const std::vector<ElasticLayer>& layers, const std::vector<DepthLevel>& levels,
             double longest, std::vector<double> cutoffs);

  /// Number of levels.
  std::size_t levels() const { return cutoffs_.size(); }
  /// Wave number beyond which the strain of a level is not needed [1/m].
  double cutoff(std::size_t level) const { return cutoffs_[level]; }
  /// Interpolates the strain at a level per traction on the top face [1/Pa].
  /// @param logarithm natural logarithm of the wave number in 1/m
  Values at(std::size_t level, double logarithm) const;

private:
  std::vector<double> cutoffs_;
  double first_ = 0, step_ = 0; ///< of the logarithm of the wave number
  Eigen::Index nodes_ = 0;
  Eigen::ArrayXXd values_; ///< [8, node + nodes * level]
};

inline DepthTable::Values DepthTable::at(std::size_t level, double logarithm) const {
  const double place = std::max((logarithm - first_) / step_, 0.0);
  const auto node = std::clamp(static_cast<Eigen::Index>(place), Eigen::Index{1}, nodes_ - 3);
  const double t = place - static_cast<double>(node);
  const auto from = node - 1 + nodes_ * static_cast<Eigen::Index>(level);
  return -t * (t - 1) * (t - 2) / 6 * values_.col(from) +
         (t + 1) * (t - 1) * (t - 2) / 2 * values_.col(from + 1) -
         (t + 1) * t * (t - 2) / 2 * values_.col(from + 2) +
         (t + 1) * t * (t - 1) / 6 * values_.col(from + 3);
}

} // namespace ionskin::finite_layers
