// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/line_operators.hpp"
#include "ionskin/poroelasticity/water_walls.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::poroelasticity {

/// Eigenmodes of the discrete diffusion operator along a line of `size` values. Values are
/// `from_modes` times amplitudes, amplitudes are `to_modes` times values, and amplitude m decays at
/// the rate diffusivity * `curvature[m]`.
struct LineModes {
  std::size_t size = 0; ///< number of values, and of modes
  /// Eigenvalues of the modes, ascending [1/m2]: 0 for the first between sealed ends; infinite for
  /// the mode of an open wall, whose value stays 0.
  std::vector<double> curvature;
  std::vector<double> to_modes, from_modes; ///< matrices, row-major [size][size]
};

/// Computes the discrete cosine modes of a row of equal cells between sealed ends, with the
/// eigenvalues of the three-point difference.
/// @param columns number of cells
/// @param width of a cell [m]
LineModes cosine_modes(std::size_t columns, double width);

/// Computes the modes of quadratic finite elements through the core, from wall to wall, with the
/// mass lumped by Simpson's rule; of order 4 (Cohen 2002, doi 10.1007/978-3-662-04823-8). The node
/// at an open wall, where the diffusing quantity is 0, is a separate mode of infinite eigenvalue.
/// @param nodes ends and midpoints of the elements, ascending [m]; their number is odd
/// @param held_share factor of the mean value in p_u, which does not diffuse: docs/model.md (75)
/// [1] Throws InternalError when the number of nodes is even or below 3.
LineModes wall_modes(const std::vector<double>& nodes, const WaterWalls& walls,
                     double held_share = 0);

/// Quadrature weights of the nodes of quadratic elements, by Simpson's rule [m]; their sum is the
/// length of the line.
std::vector<double> node_lengths(const std::vector<double>& nodes);

/// Operator that interpolates a continuous piecewise-quadratic function.
/// @param nodes ends and midpoints of its elements, where its values are given, ascending [m]
/// @param places positions at which to interpolate, ascending [m]
history::LineOperator quadratic_interpolation(const std::vector<double>& nodes,
                                              const std::vector<double>& places);

/// Nodes of `elements` quadratic elements from 0 to `thickness` [m]: ends and midpoints, 2
/// `elements` + 1 values. The ends are at Chebyshev points, so elements are short at the walls,
/// from where water under a load starts to move.
std::vector<double> wall_clustered_nodes(double thickness, std::size_t elements);

} // namespace ionskin::poroelasticity
