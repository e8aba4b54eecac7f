// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Cells of the slider's footprint, the element faces, each with one traction of given profile.
/// Those of smaller cells would oscillate: a traction that alternates within every face hardly
/// moves quadratic elements. Numbered x fastest. Every cell has three contact components: normal
/// (pressing down), along x, along y; component c of cell i is 3 i + c.
struct ContactCells {
  std::vector<double> lines_x, lines_y; ///< cell edges from the slider's centre [m]
  std::vector<double> area;             ///< [m2]
  /// Top-face nodes of the footprint, x fastest.
  std::vector<int> nodes;
  /// Nodal loads of unit forces: shape [free unknowns of the nodes, 3 cells]. Its transpose takes
  /// nodal displacements to cell means, weighted with the traction's profile; normal displacement
  /// is counted downwards.
  linear_algebra::DenseMatrix unit_load;

  std::size_t columns() const { return lines_x.size() - 1; }
  std::size_t rows() const { return lines_y.size() - 1; }
  std::size_t count() const { return area.size(); }
  CellGrid grid() const { return {lines_x, lines_y, area}; }
};

ContactCells contact_cells(const mesh::SkinMesh& mesh, const ElasticSpace& space);

} // namespace ionskin::mechanics
