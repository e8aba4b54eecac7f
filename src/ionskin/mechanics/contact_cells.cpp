// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/contact_cells.hpp"

namespace ionskin::mechanics {
namespace {

std::vector<double> subdivided(const std::vector<double>& lines, int parts) {
  std::vector<double> result{lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (int p = 1; p <= parts; ++p) {
      result.push_back(lines[i - 1] + (lines[i] - lines[i - 1]) * p / parts);
    }
  }
  return result;
}

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

std::array<double, 3> mean_shape_values(double from, double to) {
  // N0 = 2 t^2 - 3 t + 1, N1 = 4 t - 4 t^2, N2 = 2 t^2 - t; means of 1, t, t^2:
  const double t1 = (from + to) / 2, t2 = (from * from + from * to + to * to) / 3;
  return {2 * t2 - 3 * t1 + 1, 4 * t1 - 4 * t2, 2 * t2 - t1};
}

ContactCells contact_cells(const mesh::SkinMesh& mesh, const ElasticSpace& space, int per_element) {
  ContactCells cells;
  cells.lines_x = subdivided(mesh.footprint_lines_x(), per_element);
  cells.lines_y = subdivided(mesh.footprint_lines_y(), per_element);
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
  const auto parts = static_cast<std::size_t>(per_element);
  int cell = 0;
  for (std::size_t cy = 0; cy < cells.rows(); ++cy) {
    const auto part_y = static_cast<double>(cy % parts);
    const auto mean_y = mean_shape_values(part_y / per_element, (part_y + 1) / per_element);
    for (std::size_t cx = 0; cx < cells.columns(); ++cx, ++cell) {
      const auto part_x = static_cast<double>(cx % parts);
      const auto mean_x = mean_shape_values(part_x / per_element, (part_x + 1) / per_element);
      cells.area.push_back((cells.lines_x[cx + 1] - cells.lines_x[cx]) *
                           (cells.lines_y[cy + 1] - cells.lines_y[cy]));
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) {
          const std::size_t node = 2 * (cx / parts) + a + node_columns * (2 * (cy / parts) + b);
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
