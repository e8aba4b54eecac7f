// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/covered_area.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Cells of the slider's footprint, the columns of the mesh or parts of them under sharp edges, on
/// each of which the traction is even. Numbered x fastest.
/// Every cell has three contact components: normal (pressing down), along x, along y; component c
/// of cell i is 3 i + c.
struct ContactCells {
  std::vector<double> lines_x, lines_y; ///< cell edges from the slider's centre [m]
  std::vector<double> area;             ///< [m2]

  std::size_t columns() const { return lines_x.size() - 1; }
  std::size_t rows() const { return lines_y.size() - 1; }
  std::size_t count() const { return area.size(); }
  std::array<double, 2> middle(std::size_t cell) const; ///< from the slider's centre [m]
  CellGrid grid() const { return {lines_x, lines_y, area}; }
};

ContactCells contact_cells(const mesh::SkinMesh& mesh);

} // namespace ionskin::mechanics
