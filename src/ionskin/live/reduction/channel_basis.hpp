// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/reduction/reflections.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Fields of one channel (scalar field over the core, such as the shear) in samples of the contact,
/// from which the modes are made.
struct ChannelSamples {
  /// Numbers along x, y, z of the Gauss points of the mesh, and of the values of the strain
  /// history's grid.
  std::array<std::size_t, 3> points{}, cells{};
  Eigen::MatrixXf at_points; ///< values at the Gauss points [z][y][x], sample
  Eigen::MatrixXf fields;    ///< values on the grid [level][y][x], sample
};

/// Norm in which the modes of a channel are chosen and their errors measured.
struct ChannelMeasure {
  /// Square root of the volume of each Gauss point; 0 for points that may not be chosen.
  std::vector<double> point_weight;
  std::vector<double> cell_area; ///< area of each column of the grid [y][x] [m2]
  /// Combinations of the z levels that have equal weight in the norm, such as those that drive a
  /// charge [combination][level].
  Eigen::MatrixXd levels;
};

/// Modes of the fields of a channel, and the regression that gives their amplitudes from the
/// channel's values at some points. Mirror images of the samples have mirror images of the modes.
struct ChannelBasis {
  /// Indices of the chosen Gauss points; mirror images follow one another.
  std::vector<std::size_t> points;
  Eigen::MatrixXd fit;             ///< amplitudes by the values at the points [mode][point]
  Eigen::MatrixXd field;           ///< modes [level][y][x], mode
  std::vector<std::size_t> parity; ///< parity of each mode (`Reflections`)
  /// Error in samples that were not used for the fit, over their norm [1].
  double unseen = 0;
};

/// Transforms fields so that the Euclidean norm of a column is the norm of the measure: weighted
/// combinations of the levels, followed by their integrals over the area.
/// @param fields [level][y][x], sample
/// @returns [combination][y][x], then [combination]; sample
Eigen::MatrixXf measured(const Eigen::MatrixXf& fields, const ChannelMeasure& measure);

/// Projects values on a grid onto the part that has one parity under the reflections. The sum of
/// the squares over all parities equals the sum of the squares over all mirror images.
/// @param values [z][y][x], sample
/// @param size along x, y, z
Eigen::MatrixXf of_parity(const Eigen::MatrixXf& values, const std::array<std::size_t, 3>& size,
                          const Reflections& reflections, std::size_t parity);

/// Makes a basis of modes by proper orthogonal decomposition of the fields in the norm of the
/// measure, together with their integrals over the core, since charges are such integrals. Then
/// chooses points one after the other, each time the point whose values over the samples are
/// spanned worst by those at the points chosen before, until the error in unseen samples is small;
/// then fits the amplitudes of the modes to the values at the points by linear regression. Needs
/// many samples, so that no mode depends on a few points only.
ChannelBasis channel_basis(const ChannelSamples& samples, const ChannelMeasure& measure,
                           const Reflections& reflections);

/// Corrects the fit of a basis by least squares so that it reproduces samples at another position
/// of the slider, such as near the ends of the skin, where shear decays differently from the
/// middle.
/// @param samples at this position
/// @param measure with the areas of the columns that lie within the core at this position
/// @returns corrected fit [mode][point]
Eigen::MatrixXd fit_at_place(const ChannelBasis& basis, const ChannelSamples& samples,
                             const ChannelMeasure& measure);

} // namespace ionskin::live
