// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

struct StateCombination;

/// Displacement and stress of a whole skin on a grid that rides with the slider. An electrode is
/// one row of cells.
struct SkinDeformation {
  std::vector<double> x, y, z;    ///< lines, x and y from the skin's corner, z from its base [m]
  std::vector<std::size_t> layer; ///< of each row of cells between the lines along z
  /// Along x, y and upwards where lines cross, each [z][y][x], x fastest [m].
  std::array<std::vector<double>, 3> displacement;
  /// xx, yy, zz, yz, xz, xy: means over the cells, each [z][y][x] [Pa].
  std::array<std::vector<double>, 6> stress;
};

/// Displacements are strains integrated upwards from the base, which does not move: their error is
/// that of slopes by differences over the columns of the grid.
/// @param combination all at rest where it has no states
/// @param strain of these states; not asked for where there are none
SkinDeformation skin_deformation(const Skin& skin, const mesh::SkinMesh& mesh,
                                 const StateCombination& combination,
                                 const mechanics::LayerStrainAt& strain);

} // namespace ionskin::handover
