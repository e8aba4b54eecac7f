// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/free_ends.hpp"
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

} // namespace
} // namespace ionskin::mechanics
