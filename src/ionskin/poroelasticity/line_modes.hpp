// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/line_operators.hpp"
#include "ionskin/poroelasticity/water_walls.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::poroelasticity {

/// Eigenmodes of diffusion along a line of `size` values: the values are `from_modes` times the
/// amplitudes, the amplitudes `to_modes` times the values, and amplitude m decays at
/// diffusivity * `curvature[m]`.
struct LineModes {
  std::size_t size = 0;          ///< of values and of modes
  std::vector<double> curvature; ///< [modes] [1/m2], ascending, the first is 0 between sealed ends
  std::vector<double> to_modes, from_modes; ///< row-major [size][size]
};

/// Discrete cosine modes of `columns` cells of equal width between sealed ends, with the
/// eigenvalues of the three-point difference.
LineModes cosine_modes(std::size_t columns, double width);

/// Modes of quadratic finite elements between two walls, their mass lumped by Simpson's rule, of
/// order 4 (Cohen 2002, doi 10.1007/978-3-662-04823-8). An open wall, where what diffuses is 0, is
/// a mode of its own of infinite curvature.
/// @param nodes ends and middles of the elements, ascending [m]
/// @param held_share of the mean value, which does not diffuse: docs/model.md (75)
LineModes wall_modes(const std::vector<double>& nodes, const WaterWalls& walls,
                     double held_share = 0);

/// Integral of each node's share, by Simpson's rule [m].
std::vector<double> node_lengths(const std::vector<double>& nodes);

/// Values of a continuous piecewise-quadratic function, given at the ends and the middles of its
/// elements, at other places.
history::LineOperator quadratic_interpolation(const std::vector<double>& nodes,
                                              const std::vector<double>& places);

/// Nodes of `elements` quadratic elements from 0 to `thickness` [m], symmetric, short at the walls
/// (ends at Chebyshev points): water that a load drives starts to move from the walls.
std::vector<double> wall_clustered_nodes(double thickness, std::size_t elements);

} // namespace ionskin::poroelasticity
