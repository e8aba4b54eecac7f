// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/strain_recovery.hpp"

#include "small_line.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

/// Integral over the plane of a component at each level of points [m2].
std::vector<double> over_plane(const CoreStrain& strain, std::size_t component,
                               const mesh::MeshLines& lines) {
  const auto [nx, ny, nz] = strain.points;
  std::vector<double> result(nz, 0.0);
  for (std::size_t k = 0; k < nz; ++k) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const double area =
            0.25 * (lines.x[i / 2 + 1] - lines.x[i / 2]) * (lines.y[j / 2 + 1] - lines.y[j / 2]);
        result[k] += area * strain.component[component][(k * ny + j) * nx + i];
      }
    }
  }
  return result;
}

TEST(StrainRecovery, ShearOverEachLevelCarriesTheForceOfTheCells) {
  const SkinModel& model = *line().model;
  const std::array<double, 2> centre{2.1e-3, 1e-3};
  CellVector force(3 * model.cells.count(), 0.0);
  double drag = 0;
  for (std::size_t i = 1; i < force.size(); i += 3) { // a corner is loaded most
    force[i] = 1 + static_cast<double>(i * i);
    drag += force[i];
  }
  const StrainRecovery recovery(line().model, finite_layers::all_components);
  const CoreStrain strain = recovery.at(std::span(&centre, 1), std::span(&force, 1)).front().core;
  constexpr std::size_t xz = 4;
  const double shear_modulus = model.layers.layers()[1].shear_modulus;
  for (const double integral : over_plane(strain, xz, model.mesh.lines(centre))) {
    EXPECT_NEAR(2 * shear_modulus * integral, drag, 1e-4 * drag);
  }
}

} // namespace
} // namespace ionskin::mechanics
