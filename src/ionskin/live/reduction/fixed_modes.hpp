// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/live/reduction/channel_basis.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/live/skin_data.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Width beside the ends of the skin in which the field stays with them, with the slider at a
/// place; 0 along a direction in which it does not move [m].
std::array<double, 2> end_zones(const SkinData& data, const PlaceNodes& places, double thickness);

/// Cells that stay with the skin, fine at its ends; along a direction in which the slider does not
/// move those of the grid that rides with it. @param thickness of the skin [m]
std::array<std::vector<double>, 2> fixed_edges(const SkinData& data, const PlaceNodes& places,
                                               const history::StrainGrid& grid, double thickness);

/// Means over the cells that stay of fields on the grid that rides [level][y][x], sample.
Eigen::MatrixXf on_fixed_cells(const Eigen::MatrixXf& fields, const history::StrainGrid& grid,
                               const std::array<double, 2>& place,
                               const std::array<std::vector<double>, 2>& edges);

/// Remainder of the fields at a place that the riding modes leave.
struct LeftAtPlace {
  Eigen::MatrixXd values; ///< of the channel at the points of the basis [point][sample]
  Eigen::MatrixXf fields; ///< on the cells that stay [level][y][x], sample
};

/// Modes of the residual, and a regression of them on the values for each place.
struct FixedModes {
  Eigen::MatrixXd field;            ///< [level][y][x], mode
  std::vector<std::size_t> parity;  ///< of the modes
  std::vector<Eigen::MatrixXd> fit; ///< of each place [mode][point]
};

/// Modes of the remainders at all places, most important first, and their fit.
/// @param measure with the areas of the cells that stay
/// @param size of the cells along x, y, z
/// @param whole norm of the whole fields in the measure
FixedModes fixed_modes(const std::vector<LeftAtPlace>& left, const ChannelMeasure& measure,
                       const std::array<std::size_t, 3>& size, const Reflections& reflections,
                       double whole);

} // namespace ionskin::live
