// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/field_projection.hpp"

#include "ionskin/case/coupling.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::handover {

history::StrainField reflected_field(const history::StrainField& half, std::size_t levels,
                                     std::size_t rows, std::size_t columns) {
  history::StrainField full(2 * half.size());
  for (std::size_t k = 0; k < levels; ++k) {
    for (std::size_t j = 0; j < rows; ++j) {
      const auto from = half.begin() + static_cast<std::ptrdiff_t>((k * rows + j) * columns);
      const std::size_t mirror = 2 * rows - 1 - j;
      std::copy_n(from, columns,
                  full.begin() + static_cast<std::ptrdiff_t>((2 * k * rows + j) * columns));
      std::copy_n(from, columns,
                  full.begin() + static_cast<std::ptrdiff_t>((2 * k * rows + mirror) * columns));
    }
  }
  return full;
}

FieldProjection::FieldProjection(const Case& input, const mesh::SkinMesh& mesh,
                                 const MotionBox& box)
    : mesh_(mesh), core_(core_grid(input, mesh, box)), grid_(strain_grid(input, mesh, core_)),
      along_z_(moves_water(input) ? history::halved_projection(core_.z_lines)
                                  : history::linear_projection(core_.z_lines)) {}

history::StrainField FieldProjection::at(std::vector<double> at_points,
                                         const std::array<std::size_t, 3>& points,
                                         const std::array<double, 2>& centre) const {
  const auto lines = mesh_.lines(centre);
  const auto along = [](const std::vector<double>& line, std::vector<double> edges, double shift) {
    for (double& edge : edges) {
      edge += shift;
    }
    return history::compose(history::cell_averages(line, edges),
                            history::half_means_projection(line));
  };
  const history::LineOperator along_x = along(lines.x, core_.x_edges, centre[0]);
  const history::LineOperator along_y = along(lines.y, core_.y_edges, centre[1]);
  const std::size_t levels = grid_.z_nodes.size();
  history::StrainField a = std::move(at_points);
  history::StrainField b;
  history::apply_along(along_z_, 1, points[1] * points[0], a, b);
  history::apply_along(along_x, levels * points[1], 1, b, a);
  history::apply_along(along_y, levels, along_x.rows(), a, b);
  return mesh_.half_model() ? reflected_field(b, levels, along_y.rows(), along_x.rows()) : b;
}

} // namespace ionskin::handover
