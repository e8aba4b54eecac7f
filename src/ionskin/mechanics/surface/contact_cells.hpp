// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/covered_area.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Contact cells: rectangles of the skin's top face under the slider, on each of which the traction
/// is uniform. They are the columns of the mesh in the footprint; under sharp edges these are
/// divided further. Numbered with x fastest. Vectors on the cells have three components per cell:
/// normal (pressing down), along x, along y; component c of cell i is at 3 i + c.
struct ContactCells {
  std::vector<double> lines_x, lines_y; ///< cell edges from the slider's centre [m]
  std::vector<double> area;             ///< of each cell [m2]

  std::size_t columns() const { return lines_x.size() - 1; }
  std::size_t rows() const { return lines_y.size() - 1; }
  std::size_t count() const { return area.size(); }
  std::array<double, 2> middle(std::size_t cell) const; ///< x and y from the slider's centre [m]
  CellGrid grid() const { return {lines_x, lines_y, area}; }
};

/// Makes the contact cells of a mesh.
ContactCells contact_cells(const mesh::SkinMesh& mesh);

} // namespace ionskin::mechanics
