// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::electrochemistry {

/// Parameters that grade the transport grid.
struct GridResolution {
  double wall_cell = 0;    ///< first spacing at each wall [Debye lengths]
  double layer_growth = 0; ///< ratio of neighbouring spacings within a Debye length of the walls
  double acceleration = 0; ///< factor on (ratio - 1) from level to level beyond these layers
  double bulk_growth = 0;  ///< largest ratio of neighbouring spacings
  double column_width = 0; ///< width of lateral columns [core thicknesses]
};

/// Resolution of a preset. All presets grade the z levels in the same way: each is the standard one
/// refined.
GridResolution grid_resolution(Preset preset);

/// Divides every spacing of a resolution by `refinement` (above 0), with the same grading.
GridResolution refined(const GridResolution& resolution, double refinement);

/// Makes z nodes from 0 to `thickness` [m], symmetric about the middle: spacings grow slowly within
/// a Debye length of both walls, where currents change fastest after an event, and faster and
/// faster beyond; uniform where the core is only a few wall cells thick.
/// @param debye_length [m]
std::vector<double> graded_nodes(double thickness, double debye_length,
                                 const GridResolution& resolution);

/// Computes the number of lateral columns along one side of the core.
/// @param length of the side [m]
/// @param width of a column wanted [m]
/// @param fewest, most bounds that keep short sides resolved and long ones affordable
std::size_t column_count(double length, double width, std::size_t fewest, std::size_t most);

/// Chooses a number of uniform columns, `count` or more, so that borders between columns lie at the
/// given fractions of the side: at most 2 `count` where all fractions are met, else at most 1.5
/// `count` where that halves the worst distance. A column across the border of two taxels would
/// divide its charge between them by area.
/// @param step difference between the numbers to choose from
/// @param fractions of the side, 0 to 1
std::size_t aligned_column_count(std::size_t count, std::size_t step,
                                 const std::vector<double>& fractions);

/// Makes the transport grid of a case for a strain history. Columns end at the edges of taxels, and
/// of leads at a corner, where a suitable number of columns exists. A direction along which the
/// history has a single cell at rest needs only one column, unless taxels with circuits of their
/// own end along it, or charge moves along it in metal with a sheet resistance. Such a taxel has at
/// least two columns. Along y the number of columns is even otherwise, so that half of them can be
/// solved where the shear is symmetric about mid-width.
TransportGrid make_transport_grid(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
