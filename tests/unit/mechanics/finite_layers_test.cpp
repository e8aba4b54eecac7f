// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "ionskin/finite_layers/fields/skin_fields.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

namespace fl = finite_layers;

/// Compliance of the cells of a mesh by finite layers, which share nothing with it but the cells.
Eigen::MatrixXd by_finite_layers(const Case& input, const SkinModel& model,
                                 const std::array<double, 2>& centre, bool free_ends) {
  const fl::SurfaceCompliance surface(fl::elastic_layers(input.skin));
  const fl::WaveSplit split(0.5e-3, 1e-3);
  const double length = input.skin.length, width = input.skin.width;
  const fl::ContactGrid grid{model.cells.lines_x, model.cells.lines_y, model.mesh.half_model()};
  const fl::ThicknessColumn column(surface.layers(), {{1}, {1, 2, 2, 1}, {1}}, 3);
  const fl::BoxModes modes(surface, length, width, split);
  const fl::FreeSides sides(column, length, width, split, {60, 60});
  const fl::FreeEnds ends(column, length, width, split, {16, 120}, &sides);
  auto rows = modes.rows(grid, centre[1]);
  sides.add(grid, centre[1], rows);
  Eigen::MatrixXd compliance =
      fl::short_wave_compliance(fl::ShortWaveCompliance(surface, split), grid);
  fl::add_modes(rows, modes.along_x(), grid, centre[0], compliance);
  if (free_ends) {
    ends.rows(grid, centre[1]).add(grid, centre[0], compliance);
  }
  return compliance;
}

/// Tractions that are even over a disc, along one component [N].
Eigen::VectorXd disc_load(const ContactCells& cells, int component) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(cells.count()));
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    const std::size_t i = cell % cells.columns(), j = cell / cells.columns();
    const double x = 0.5 * (cells.lines_x[i] + cells.lines_x[i + 1]),
                 y = 0.5 * (cells.lines_y[j] + cells.lines_y[j + 1]);
    if (std::hypot(x, y) < 0.25e-3) {
      force(3 * static_cast<Eigen::Index>(cell) + component) = cells.area[cell];
    }
  }
  return force;
}

double work_of(const linear_algebra::DenseMatrix& compliance, const Eigen::VectorXd& force) {
  double sum = 0;
  for (int row = 0; row < compliance.rows; ++row) {
    for (int column = 0; column < compliance.columns; ++column) {
      sum += force(row) * compliance(row, column) * force(column);
    }
  }
  return sum;
}

// Two methods that share the cells alone. Finite elements are too stiff, on this coarse mesh by a
// few per cent; an end on rollers would be, too, though only along the skin.
TEST(FiniteLayers, are_what_finite_elements_come_near_to) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters = {{"slider.radius", 10e-3}};
  const std::array<double, 2> centre{0.7e-3, 1e-3}; // near an end
  const SkinModel model(input, {{0.3e-3, 0.3e-3}, {0.3e-3, 0.3e-3}});
  const CondensedPosition elements(model, centre);
  const Eigen::MatrixXd layers = by_finite_layers(input, model, centre, true),
                        rollers = by_finite_layers(input, model, centre, false);
  constexpr std::array<double, 3> stiffer{0.06, 0.01, 0.025}; // normal, along x, along y
  for (int component = 0; component < 3; ++component) {
    const Eigen::VectorXd force = disc_load(model.cells, component);
    const double exact = force.dot(layers * force), found = work_of(elements.compliance(), force);
    EXPECT_LT(found, exact) << component;
    EXPECT_GT(found, (1 - stiffer[static_cast<std::size_t>(component)]) * exact) << component;
    if (component == 1) {
      EXPECT_LT(force.dot(rollers * force), 0.95 * found);
    }
  }
}

/// Gauss points of elements between lines, two of each.
std::vector<double> gauss_points(const std::vector<double>& lines, std::size_t first,
                                 std::size_t last) {
  std::vector<double> points;
  for (std::size_t i = first; i < last; ++i) {
    const double middle = 0.5 * (lines[i] + lines[i + 1]);
    const double offset = 0.5 * (lines[i + 1] - lines[i]) / std::sqrt(3.0);
    points.push_back(middle - offset);
    points.push_back(middle + offset);
  }
  return points;
}

// The strain in the core at the points of the elements, and that of the electrodes. The mesh has
// two elements through the core; under the normal load they differ by 10 % of the core's strain and
// 4 % of the electrodes', and on a mesh of the preset standard by 2.2 % and 0.6 %.
TEST(FiniteLayers, strain_the_core_as_finite_elements_do) {
  Case input = small_case();
  input.slider.shape = "sphere";
  input.slider.parameters = {{"slider.radius", 10e-3}};
  const std::array<double, 2> centre{1.0e-3, 1e-3};
  const SkinModel model(input, {{0.3e-3, 0.3e-3}, {0.3e-3, 0.3e-3}});
  const CondensedPosition elements(model, centre);
  const mesh::MeshLines lines = model.mesh.lines(centre);
  const fl::SurfaceCompliance surface(fl::elastic_layers(input.skin));
  const fl::WaveSplit split(0.5e-3, 1e-3);
  const double length = input.skin.length, width = input.skin.width;
  const fl::ContactGrid cells{model.cells.lines_x, model.cells.lines_y, model.mesh.half_model()};
  const fl::ThicknessColumn column(surface.layers(), {{1}, {1, 2, 2, 1}, {1}}, 3);
  const fl::FreeSides sides(column, length, width, split, {40, 60});
  const fl::FreeEnds ends(column, length, width, split, {10, 80}, &sides);
  fl::FieldGrid grid{gauss_points(lines.x, 0, lines.x.size() - 1),
                     gauss_points(lines.y, 0, lines.y.size() - 1),
                     gauss_points(lines.z, model.core_z[0], model.core_z[1]), lines.x, lines.y};
  for (double& z : grid.z) {
    z -= lines.z[model.core_z[0]];
  }
  const fl::SkinFields fields({surface.layers(), 1, length, width, &column, &sides, &ends}, cells,
                              grid, split);
  constexpr std::array<double, 2> core_limit{0.12, 0.05}, electrode_limit{0.06, 0.02};
  for (const std::size_t component : {0u, 1u}) {
    const Eigen::VectorXd load = disc_load(model.cells, static_cast<int>(component));
    const std::vector<double> force(load.data(), load.data() + load.size());
    const CondensedPosition::Response response = elements.respond({force}).front();
    const CoreStrain found = elements.strain(response);
    const fl::CoreAndElectrodes exact = fields.at(centre, force);
    double squares = 0, differences = 0;
    for (std::size_t c = 0; c < 6; ++c) {
      ASSERT_EQ(found.component[c].size(), exact.core.component[c].size());
      for (std::size_t i = 0; i < found.component[c].size(); ++i) {
        squares += std::pow(exact.core.component[c][i], 2);
        differences += std::pow(found.component[c][i] - exact.core.component[c][i], 2);
      }
    }
    EXPECT_LT(std::sqrt(differences / squares), core_limit[component]) << component;
    squares = differences = 0;
    const std::size_t columns = (lines.x.size() - 1) * (lines.y.size() - 1);
    for (std::size_t layer = 0; layer < 2; ++layer) {
      for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t c = 0; c < 6; ++c) {
          const double value = exact.electrodes.component[c][i + columns * layer];
          squares += value * value;
          differences +=
              std::pow(response.electrode_strain[c + 6 * (i + columns * layer)] - value, 2);
        }
      }
    }
    EXPECT_LT(std::sqrt(differences / squares), electrode_limit[component]) << component;
  }
}

} // namespace
} // namespace ionskin::mechanics
