// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/depth_strain.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// `depth_strain` at levels over the wave number, tabulated once and interpolated by cubics in its
/// logarithm. The table of a level fits the first cache of a processor, so that looking up is
/// cheaper than keeping the values of all modes.
class DepthTable {
public:
  using Values = Eigen::Array<double, 8, 1>; ///< in the order of `DepthStrain`

  /// @param longest wave number below which a column is loaded evenly [1/m]
  /// @param cutoffs wave number of each level beyond which nothing is asked for [1/m]
  DepthTable(const std::vector<ElasticLayer>& layers, const std::vector<DepthLevel>& levels,
             double longest, std::vector<double> cutoffs);

  std::size_t levels() const { return cutoffs_.size(); }
  double cutoff(std::size_t level) const { return cutoffs_[level]; }
  /// Strain at a level over the motion of a wave, by cubic interpolation.
  /// @param logarithm of the wave number over 1/m
  Values at(std::size_t level, double logarithm) const;

private:
  std::vector<double> cutoffs_;
  double first_ = 0, step_ = 0; ///< of the logarithm
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
