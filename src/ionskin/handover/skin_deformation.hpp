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

/// Displacement and stress of a whole skin on a grid that moves with the slider, calculated by
/// `skin_deformation`. Each electrode is one row of cells.
struct SkinDeformation {
  /// Grid lines: x and y from the skin's corner, z from its base [m].
  std::vector<double> x, y, z;
  /// Index of the layer of each row of cells along z, bottom to top.
  std::vector<std::size_t> layer;
  /// Displacement along x, y and z (upwards) where grid lines cross, each [z][y][x], x fastest [m].
  std::array<std::vector<double>, 3> displacement;
  /// Mean stress of each cell, components xx, yy, zz, yz, xz, xy, each [z][y][x], x fastest [Pa].
  std::array<std::vector<double>, 6> stress;
};

/// Calculates displacement and stress from the strain. Strain is integrated upwards from the base,
/// which does not move. The error of the displacement is that of slopes, which are differences over
/// the columns of the grid.
/// @param combination states of the contact; the skin is at rest if it is empty
/// @param strain gives the strain of a state; not called if there are no states
SkinDeformation skin_deformation(const Skin& skin, const mesh::SkinMesh& mesh,
                                 const StateCombination& combination,
                                 const mechanics::LayerStrainAt& strain);

} // namespace ionskin::handover
