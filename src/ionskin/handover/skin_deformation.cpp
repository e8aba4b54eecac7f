// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/skin_deformation.hpp"

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"
#include "ionskin/handover/contact_timeline.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace ionskin::handover {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;

enum Component { xx, yy, zz, yz, xz, xy };

/// Row of cells within one layer, [x, y].
struct Row {
  std::size_t layer = 0;
  double height = 0;              ///< [m]
  std::array<ArrayXXd, 6> strain; ///< means over the cells [1]
  /// Integral over the height of the upward displacement relative to the bottom of the row [m2].
  ArrayXXd rise;
};

void add(const mechanics::CoreStrain& own, double weight, mechanics::CoreStrain& sum) {
  sum.points = own.points;
  for (std::size_t c = 0; c < 6; ++c) {
    sum.component[c].resize(own.component[c].size(), 0.0);
    for (std::size_t i = 0; i < own.component[c].size(); ++i) {
      sum.component[c][i] += weight * own.component[c][i];
    }
  }
}

mechanics::LayerStrain combined(const StateCombination& combination,
                                const mechanics::LayerStrainAt& strain) {
  mechanics::LayerStrain sum;
  for (const auto& [state, weight] : combination.terms) {
    const mechanics::LayerStrain own = strain(state->place);
    add(own.core, weight, sum.core);
    add(own.electrodes, weight, sum.electrodes);
  }
  return sum;
}

ArrayXXd level(const mechanics::CoreStrain& strain, int component, std::size_t z) {
  const auto nx = static_cast<Eigen::Index>(strain.points[0]),
             ny = static_cast<Eigen::Index>(strain.points[1]);
  return Eigen::Map<const ArrayXXd>(strain.component[static_cast<std::size_t>(component)].data() +
                                        nx * ny * static_cast<Eigen::Index>(z),
                                    nx, ny);
}

/// Averages a level of points over the cells, with two by two points in a cell.
ArrayXXd cell_means(const ArrayXXd& points) {
  const auto even_x = Eigen::seq(0, points.rows() - 2, 2),
             odd_x = Eigen::seq(1, points.rows() - 1, 2);
  const auto even_y = Eigen::seq(0, points.cols() - 2, 2),
             odd_y = Eigen::seq(1, points.cols() - 1, 2);
  return 0.25 * (points(even_x, even_y) + points(odd_x, even_y) + points(even_x, odd_y) +
                 points(odd_x, odd_y));
}

/// Averages the strain of the core between two lines along z, which hold two levels of points.
Row core_row(const mechanics::CoreStrain& core, std::size_t row, double height) {
  Row result{0, height, {}, {}};
  for (int c = 0; c < 6; ++c) {
    const ArrayXXd lower = cell_means(level(core, c, 2 * row)),
                   upper = cell_means(level(core, c, 2 * row + 1));
    result.strain[static_cast<std::size_t>(c)] = 0.5 * (lower + upper);
    if (c == zz) { // strain at a lower point raises more of the row
      const double offset = height / (2 * std::sqrt(3.0));
      result.rise =
          0.5 * height * ((0.5 * height + offset) * lower + (0.5 * height - offset) * upper);
    }
  }
  return result;
}

Row electrode_row(const mechanics::CoreStrain& electrodes, std::size_t which, double height) {
  Row result{0, height, {}, {}};
  for (int c = 0; c < 6; ++c) {
    result.strain[static_cast<std::size_t>(c)] = level(electrodes, c, which);
  }
  result.rise = 0.5 * height * height * result.strain[zz];
  return result;
}

/// Continues values on the half y <= width / 2 by their mirror image, times `sign`.
/// @param half [x, y]
ArrayXXd whole(const ArrayXXd& half, double sign) {
  ArrayXXd result(half.rows(), 2 * half.cols());
  result << half, sign * half.rowwise().reverse();
  return result;
}

void add_mirror_image(Row& row) {
  for (int c = 0; c < 6; ++c) {
    ArrayXXd& strain = row.strain[static_cast<std::size_t>(c)];
    strain = whole(strain, c == yz || c == xy ? -1 : 1);
  }
  row.rise = whole(row.rise, 1);
}

/// Calculates the slope along the first index, by parabolas through three neighbours.
ArrayXXd slope(const ArrayXXd& values, const ArrayXd& at) {
  const Eigen::Index last = at.size() - 1;
  ArrayXXd result = ArrayXXd::Zero(values.rows(), values.cols());
  for (Eigen::Index i = 0; last > 1 && i <= last; ++i) {
    const Eigen::Index b = std::clamp<Eigen::Index>(i, 1, last - 1), a = b - 1, c = b + 1;
    const double x = at(i);
    result.row(i) = (2 * x - at(b) - at(c)) / ((at(a) - at(b)) * (at(a) - at(c))) * values.row(a) +
                    (2 * x - at(a) - at(c)) / ((at(b) - at(a)) * (at(b) - at(c))) * values.row(b) +
                    (2 * x - at(a) - at(b)) / ((at(c) - at(a)) * (at(c) - at(b))) * values.row(c);
  }
  return result;
}

ArrayXd middles(const std::vector<double>& lines) {
  const Eigen::Map<const ArrayXd> at(lines.data(), static_cast<Eigen::Index>(lines.size()));
  return 0.5 * (at.head(at.size() - 1) + at.tail(at.size() - 1));
}

/// Interpolates from the middles of columns to the lines between them, linearly, also beyond the
/// outer middles.
ArrayXXd on_lines(const ArrayXXd& values, const ArrayXd& at, const std::vector<double>& lines) {
  ArrayXXd result(static_cast<Eigen::Index>(lines.size()), values.cols());
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    const Eigen::Index b = std::clamp<Eigen::Index>(i, 1, std::max<Eigen::Index>(at.size() - 1, 1)),
                       a = b - 1;
    const double share =
        at.size() > 1 ? (lines[static_cast<std::size_t>(i)] - at(a)) / (at(b) - at(a)) : 0;
    result.row(i) = (1 - share) * values.row(a) + share * values.row(std::min(b, at.size() - 1));
  }
  return result;
}

void append(const ArrayXXd& values, std::vector<double>& to) {
  to.insert(to.end(), values.data(), values.data() + values.size());
}

std::vector<Row> rows_of(const mechanics::LayerStrain& strain, const Skin& skin,
                         const mesh::SkinMesh& mesh) {
  const std::vector<double>& z = mesh.lines_z();
  std::vector<Row> rows;
  std::size_t electrode = 0;
  for (std::size_t layer = 0; layer < skin.layers.size(); ++layer) {
    if (layer != skin.core_index()) {
      rows.push_back(electrode_row(strain.electrodes, electrode++, skin.layers[layer].thickness));
      rows.back().layer = layer;
      continue;
    }
    const auto [first, end] = mesh.core_z();
    for (std::size_t row = first; row < end; ++row) {
      rows.push_back(core_row(strain.core, row - first, z[row + 1] - z[row]));
      rows.back().layer = layer;
    }
  }
  return rows;
}

/// Makes zero strain, for a skin at rest.
mechanics::LayerStrain nothing(const mesh::SkinMesh& mesh, const Skin& skin) {
  const auto [nx, ny, nz] = mesh.elements();
  const auto core = mesh.core_z();
  mechanics::LayerStrain result{{{2 * nx, 2 * ny, 2 * (core[1] - core[0])}, {}},
                                {{nx, ny, skin.layers.size() - 1}, {}}};
  for (mechanics::CoreStrain* part : {&result.core, &result.electrodes}) {
    for (std::vector<double>& component : part->component) {
      component.resize(part->points[0] * part->points[1] * part->points[2]);
    }
  }
  return result;
}

void add_stress(const finite_layers::ElasticLayer& layer, const Row& row, SkinDeformation& result) {
  const ArrayXXd pressure = layer.lame_lambda * (row.strain[xx] + row.strain[yy] + row.strain[zz]);
  for (std::size_t c = 0; c < 6; ++c) {
    const ArrayXXd deviation = 2 * layer.shear_modulus * row.strain[c];
    append(c <= zz ? ArrayXXd(pressure + deviation) : deviation, result.stress[c]);
  }
}

} // namespace

SkinDeformation skin_deformation(const Skin& skin, const mesh::SkinMesh& mesh,
                                 const StateCombination& combination,
                                 const mechanics::LayerStrainAt& strain) {
  mesh::MeshLines lines = mesh.lines(combination.centre);
  const std::vector<finite_layers::ElasticLayer> layers = finite_layers::elastic_layers(skin);
  std::vector<Row> rows = rows_of(
      combination.terms.empty() ? nothing(mesh, skin) : combined(combination, strain), skin, mesh);
  if (mesh.half_model()) {
    for (std::size_t i = lines.y.size() - 1; i > 0; --i) {
      lines.y.push_back(skin.width - lines.y[i - 1]);
    }
    std::ranges::for_each(rows, add_mirror_image);
  }
  SkinDeformation result{lines.x, lines.y, {0}, {}, {}, {}};
  const ArrayXd x = middles(lines.x), y = middles(lines.y);
  ArrayXXd up = ArrayXXd::Zero(x.size(), y.size());
  ArrayXXd shear_x = up, shear_y = up,
           sum = up; // integrals of 2 e_xz, 2 e_yz and u_z from the base
  const auto add_level = [&] {
    const std::array<ArrayXXd, 3> moved{shear_x - slope(sum, x),
                                        shear_y - slope(sum.transpose(), y).transpose(), up};
    for (std::size_t c = 0; c < 3; ++c) {
      const ArrayXXd along_x = on_lines(moved[c], x, lines.x);
      append(on_lines(along_x.transpose(), y, lines.y).transpose(), result.displacement[c]);
    }
  };
  add_level();
  for (const Row& row : rows) {
    sum += row.height * up + row.rise;
    up += row.height * row.strain[zz];
    shear_x += 2 * row.height * row.strain[xz];
    shear_y += 2 * row.height * row.strain[yz];
    result.z.push_back(result.z.back() + row.height);
    result.layer.push_back(row.layer);
    add_stress(layers[row.layer], row, result);
    add_level();
  }
  return result;
}

} // namespace ionskin::handover
