// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/strain_channels.hpp"
#include "ionskin/history/line_operators.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <vector>

namespace ionskin::handover {

/// Strain at the points of a mesh that rides with a slider, see mechanics::CoreStrain.
struct MeshStrain {
  mesh::MeshLines lines;
  std::vector<double> core_z;          ///< lines through the core, from its bottom [m]
  std::array<std::size_t, 3> points{}; ///< along x, y and z
  PointStrain strain;
};

/// Operators along z, y and x of a field [z][y][x].
using FieldOperators = std::array<history::LineOperator, 3>;

/// A field after operators along its three axes.
/// @param points of the field along x, y and z
std::vector<double> applied(const FieldOperators& along, std::vector<double> field,
                            const std::array<std::size_t, 3>& points);

/// Adds to a strain another one of the same skin on a mesh of its own. Along x and y the values of
/// both are means over halves of cells, which keep their integral.
void add_strain(const MeshStrain& other, MeshStrain& strain);

/// Operators from the points of a mesh to fixed cells: means over the cells, linear between nodes
/// through the thickness.
/// @param z_lines of the core, between which its nodes lie, from its bottom [m]
FieldOperators onto_cells(const MeshStrain& from, const history::StrainGrid& grid,
                          const std::vector<double>& z_lines);

} // namespace ionskin::handover
