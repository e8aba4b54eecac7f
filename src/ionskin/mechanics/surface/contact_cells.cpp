// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include "ionskin/mechanics/surface/traction_profile.hpp"

#include <array>

namespace ionskin::mechanics {
namespace {

/// The first free unknown of each node and component in the order of the nodes.
std::vector<std::array<int, 3>> local_unknowns(const ElasticSpace& space,
                                               const std::vector<int>& nodes, int& count) {
  std::vector<std::array<int, 3>> result;
  count = 0;
  for (const int node : nodes) {
    std::array<int, 3>& local = result.emplace_back();
    for (int c = 0; c < 3; ++c) {
      local[c] = space.unknown(node)[c] < 0 ? -1 : count++;
    }
  }
  return result;
}

} // namespace

ContactCells contact_cells(const mesh::SkinMesh& mesh, const ElasticSpace& space) {
  ContactCells cells;
  cells.lines_x = mesh.footprint_lines_x();
  cells.lines_y = mesh.footprint_lines_y();
  const auto [first_x, last_x] = mesh.footprint_x();
  const auto [first_y, last_y] = mesh.footprint_y();
  const std::size_t top = 2 * space.elements()[2];
  for (std::size_t j = 2 * first_y; j <= 2 * last_y; ++j) {
    for (std::size_t i = 2 * first_x; i <= 2 * last_x; ++i) {
      cells.nodes.push_back(space.node_at(i, j, top));
    }
  }
  int unknowns = 0;
  const auto local = local_unknowns(space, cells.nodes, unknowns);
  const std::size_t node_columns = 2 * (last_x - first_x) + 1;
  const int cell_count = static_cast<int>(cells.columns() * cells.rows());
  cells.unit_load = linear_algebra::DenseMatrix(unknowns, 3 * cell_count);
  constexpr std::array<int, 3> displacement_component{2, 0, 1};
  const TractionProfile profile_x(mesh, 0), profile_y(mesh, 1);
  int cell = 0;
  for (std::size_t cy = 0; cy < cells.rows(); ++cy) {
    const auto mean_y = profile_y.mean_shape_values(cells.lines_y[cy], cells.lines_y[cy + 1]);
    for (std::size_t cx = 0; cx < cells.columns(); ++cx, ++cell) {
      const auto mean_x = profile_x.mean_shape_values(cells.lines_x[cx], cells.lines_x[cx + 1]);
      cells.area.push_back((cells.lines_x[cx + 1] - cells.lines_x[cx]) *
                           (cells.lines_y[cy + 1] - cells.lines_y[cy]));
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) {
          const std::size_t node = 2 * cx + a + node_columns * (2 * cy + b);
          for (int c = 0; c < 3; ++c) {
            const int row = local[node][displacement_component[c]];
            if (row >= 0) {
              cells.unit_load(row, 3 * cell + c) += (c == 0 ? -1 : 1) * mean_x[a] * mean_y[b];
            }
          }
        }
      }
    }
  }
  return cells;
}

} // namespace ionskin::mechanics
