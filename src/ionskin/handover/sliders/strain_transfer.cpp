// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/sliders/strain_transfer.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace ionskin::handover {
namespace {

/// Lists both Gauss points of each interval.
std::vector<double> gauss_points(const std::vector<double>& lines) {
  const double offset = 0.5 / std::sqrt(3.0);
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double length = lines[i + 1] - lines[i], middle = 0.5 * (lines[i] + lines[i + 1]);
    places.push_back(middle - offset * length);
    places.push_back(middle + offset * length);
  }
  return places;
}

/// Makes an operator that returns each value as it is.
history::LineOperator identity(std::size_t count) {
  history::LineOperator same{count, {}, std::vector(count, std::vector{1.0})};
  for (std::size_t i = 0; i < count; ++i) {
    same.first.push_back(i);
  }
  return same;
}

/// Makes the operators from the points of one mesh to the points of another.
FieldOperators between(const MeshStrain& from, const MeshStrain& to) {
  const auto along = [](const std::vector<double>& lines, const std::vector<double>& target) {
    return history::half_means_averages(lines, history::halved(target));
  };
  return {from.core_z == to.core_z ? identity(from.points[2])
                                   : history::compose(history::linear_interpolation(
                                                          from.core_z, gauss_points(to.core_z)),
                                                      history::linear_projection(from.core_z)),
          along(from.lines.y, to.lines.y), along(from.lines.x, to.lines.x)};
}

} // namespace

std::vector<double> applied(const FieldOperators& along, std::vector<double> field,
                            const std::array<std::size_t, 3>& points) {
  std::vector<double> next;
  history::apply_along(along[0], 1, points[1] * points[0], field, next);
  history::apply_along(along[1], along[0].rows(), points[0], next, field);
  history::apply_along(along[2], along[0].rows() * along[1].rows(), 1, field, next);
  return next;
}

void add_strain(const MeshStrain& other, MeshStrain& strain) {
  const FieldOperators along = between(other, strain);
  for (std::size_t c = 0; c < strain.strain.size(); ++c) {
    if (other.strain[c].empty()) {
      continue;
    }
    const auto carried = applied(along, other.strain[c], other.points);
    for (std::size_t i = 0; i < carried.size(); ++i) {
      strain.strain[c][i] += carried[i];
    }
  }
}

FieldOperators onto_cells(const MeshStrain& from, const history::StrainGrid& grid,
                          const std::vector<double>& z_lines) {
  const bool halved = grid.z_nodes.size() > z_lines.size();
  history::LineOperator along_z =
      halved ? history::halved_projection(from.core_z) : history::linear_projection(from.core_z);
  if (from.core_z != z_lines) { // the mesh differs through the thickness
    along_z =
        history::compose(history::linear_interpolation(
                             halved ? history::halved(from.core_z) : from.core_z, grid.z_nodes),
                         along_z);
  }
  return {std::move(along_z), history::half_means_averages(from.lines.y, grid.y_edges),
          history::half_means_averages(from.lines.x, grid.x_edges)};
}

} // namespace ionskin::handover
