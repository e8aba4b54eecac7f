// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"

namespace ionskin::mechanics {

ContactCells contact_cells(const mesh::SkinMesh& mesh) {
  ContactCells cells{mesh.footprint_lines_x(), mesh.footprint_lines_y(), {}};
  for (std::size_t j = 0; j < cells.rows(); ++j) {
    for (std::size_t i = 0; i < cells.columns(); ++i) {
      cells.area.push_back((cells.lines_x[i + 1] - cells.lines_x[i]) *
                           (cells.lines_y[j + 1] - cells.lines_y[j]));
    }
  }
  return cells;
}

} // namespace ionskin::mechanics
