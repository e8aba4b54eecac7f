// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/reduction/reflections.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// A channel of the core in samples of the contact.
struct ChannelSamples {
  std::array<std::size_t, 3> points{},
      cells{};               ///< along x, y, z: Gauss points, grid of the history
  Eigen::MatrixXf at_points; ///< [z][y][x], sample
  Eigen::MatrixXf fields;    ///< [level][y][x], sample
};

/// Measure by which the modes of a channel are chosen.
struct ChannelMeasure {
  std::vector<double> point_weight; ///< of a Gauss point: root of its volume; 0: not to be chosen
  std::vector<double> cell_area;    ///< of a column of the grid, [y][x] [m2]
  /// Rows are combinations of the levels that count alike, such as those that drive a charge.
  Eigen::MatrixXd levels;
};

/// Modes of the fields, and how the channel's values at some points tell them. Reflected samples
/// have reflected modes.
struct ChannelBasis {
  std::vector<std::size_t> points;
  Eigen::MatrixXd fit;             ///< [mode][point]
  Eigen::MatrixXd field;           ///< [level][y][x], mode
  std::vector<std::size_t> parity; ///< of the modes
  double unseen = 0; ///< error in samples that were kept from the fit, of their norm [1]
};

/// The fields in the measure, and below them their integrals.
Eigen::MatrixXf measured(const Eigen::MatrixXf& fields, const ChannelMeasure& measure);

/// Values and their reflections as the part of a parity. @param size along x, y, z
Eigen::MatrixXf of_parity(const Eigen::MatrixXf& values, const std::array<std::size_t, 3>& size,
                          const Reflections& reflections, std::size_t parity);

/// Proper orthogonal decomposition of the fields, in the measure, together with their integrals
/// over the core, which are charges; then the points whose values span those of all others best,
/// one after the other, and as many as it takes; then a linear regression of the modes on them. As
/// the samples are many, no mode is fixed by a few points alone.
ChannelBasis channel_basis(const ChannelSamples& samples, const ChannelMeasure& measure,
                           const Reflections& reflections);

/// The fit of a basis where samples of another place are to be met, as far as the basis is from
/// them: near the ends of the skin shear fades otherwise than in its middle.
/// @param measure with the areas of the cells that lie within the core there
Eigen::MatrixXd fit_at_place(const ChannelBasis& basis, const ChannelSamples& samples,
                             const ChannelMeasure& measure);

} // namespace ionskin::live
