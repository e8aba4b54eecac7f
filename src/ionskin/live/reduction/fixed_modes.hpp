// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/reduction/channel_basis.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Widths of the zones at the ends of the skin in which the strain field stays with the skin
/// instead of moving with the slider, along x and y; 0 along a direction in which the slider does
/// not move [m].
/// @param thickness of the skin [m]
std::array<double, 2> end_zones(const SkinData& data, const PlaceNodes& places, double thickness);

/// Edges along x and y of a grid that is fixed to the skin, fine at its ends; along a direction in
/// which the slider does not move, the edges of the grid that moves with the slider [m].
/// @param grid that moves with the slider
/// @param thickness of the skin [m]
std::array<std::vector<double>, 2> fixed_edges(const SkinData& data, const PlaceNodes& places,
                                               const history::StrainGrid& grid, double thickness);

/// Averages fields from the grid that moves with the slider onto cells that are fixed to the skin.
/// @param fields [level][y][x], sample
/// @param grid that moves with the slider
/// @param place position of the slider's centre [m]
/// @param edges of the fixed cells along x and y [m]
/// @returns [level][y][x], sample
Eigen::MatrixXf on_fixed_cells(const Eigen::MatrixXf& fields, const history::StrainGrid& grid,
                               const std::array<double, 2>& place,
                               const std::array<std::vector<double>, 2>& edges);

/// Part of the fields that the modes moving with the slider do not represent, at one position of
/// the slider.
struct LeftAtPlace {
  Eigen::MatrixXd values; ///< values of the channel at the points of the basis [point][sample]
  /// Remainder on the cells that are fixed to the skin [level][y][x], sample.
  Eigen::MatrixXf fields;
};

/// Modes of the remainders (`LeftAtPlace`), which stay with the skin, and for each position a
/// regression of their amplitudes on the channel's values at the points of the basis.
struct FixedModes {
  Eigen::MatrixXd field;            ///< modes [level][y][x], mode
  std::vector<std::size_t> parity;  ///< parity of each mode (`Reflections`)
  std::vector<Eigen::MatrixXd> fit; ///< regression at each position [mode][point]
};

/// Makes the modes of the remainders at all positions, most important first, and their regression.
/// @param measure norm, with the areas of the fixed cells
/// @param size numbers of fixed cells along x and y, and of z levels
/// @param whole norm of the complete fields in the measure, relative to which modes are negligible
FixedModes fixed_modes(const std::vector<LeftAtPlace>& left, const ChannelMeasure& measure,
                       const std::array<std::size_t, 3>& size, const Reflections& reflections,
                       double whole);

} // namespace ionskin::live
