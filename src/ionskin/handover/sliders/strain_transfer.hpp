// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/strain_channels.hpp"
#include "ionskin/history/line_operators.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <vector>

namespace ionskin::handover {

/// Strain at the points of a mesh that moves with a slider, see `mechanics::CoreStrain`.
struct MeshStrain {
  mesh::MeshLines lines;               ///< mesh lines of the skin
  std::vector<double> core_z;          ///< mesh lines through the core, from its bottom [m]
  std::array<std::size_t, 3> points{}; ///< number of points along x, y and z
  PointStrain strain;
};

/// One-dimensional operators along z, y and x, in this order, for a field [z][y][x].
using FieldOperators = std::array<history::LineOperator, 3>;

/// Applies operators to a field along its three axes, and returns the result [z][y][x].
/// @param field [z][y][x]
/// @param points number of values of the field along x, y and z
std::vector<double> applied(const FieldOperators& along, std::vector<double> field,
                            const std::array<std::size_t, 3>& points);

/// Adds to a strain another strain of the same skin that is given on another mesh. Along x and y
/// the values of both are means over halves of cells, which conserve the integral.
/// @param other strain to be added
/// @param strain to which it is added, at its own points
void add_strain(const MeshStrain& other, MeshStrain& strain);

/// Makes the operators that carry a field from the points of a mesh to cells at rest: means over
/// the cells in the plane, continuous and linear through the thickness.
/// @param from mesh that moves with a slider
/// @param z_lines mesh lines of the core that the z nodes of `grid` follow, from the bottom of the
/// core [m]
FieldOperators onto_cells(const MeshStrain& from, const history::StrainGrid& grid,
                          const std::vector<double>& z_lines);

} // namespace ionskin::handover
