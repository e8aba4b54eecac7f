// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::electrochemistry {

/// Resolution of the transport grid.
struct GridResolution {
  double wall_cell = 0;    ///< first spacing at each wall [Debye lengths]
  double layer_growth = 0; ///< ratio of neighbouring spacings within a Debye length of the walls
  double acceleration = 0; ///< factor on the excess of that ratio over 1 from level to level behind
  double bulk_growth = 0;  ///< largest ratio of neighbouring spacings
  double column_width = 0; ///< lateral columns [core thicknesses]
};

/// The presets grade the levels alike: each is the standard one refined.
GridResolution grid_resolution(Preset preset);

/// Resolution with every spacing of `resolution` divided by `refinement` (above 0), graded alike.
GridResolution refined(const GridResolution& resolution, double refinement);

/// Nodes from 0 to `thickness` [m], symmetric: spacings grow slowly within a Debye length of both
/// walls, where currents change fastest after an event, and faster and faster behind; uniform where
/// the core is but a few wall cells thick.
std::vector<double> graded_nodes(double thickness, double debye_length,
                                 const GridResolution& resolution);

/// Columns along one side of the core: about `width` wide [m], within bounds that keep short sides
/// resolved and long ones affordable.
std::size_t column_count(double length, double width, std::size_t fewest, std::size_t most);

/// Number of uniform columns, `count` or more, so that borders between them lie at the given
/// fractions of the side: at most twice as many where all fit, else at most half as many again
/// where that halves the worst distance. The column of a border between two taxels would share its
/// charge among them by area.
/// @param step between the numbers to choose from
std::size_t aligned_column_count(std::size_t count, std::size_t step,
                                 const std::vector<double>& fractions);

/// The grid of a case, whose columns end at the edges of the taxels, and of leads at a corner,
/// where such a number of columns exists. A direction in which the history has a single cell at
/// rest needs, and gets, a single column, unless taxels with circuits of their own end along it, or
/// charge moves along it in metal with a sheet resistance; such a taxel has two columns at least.
/// Across the width their number is even otherwise, so that half of them do where the shear is its
/// own mirror image.
TransportGrid make_transport_grid(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
