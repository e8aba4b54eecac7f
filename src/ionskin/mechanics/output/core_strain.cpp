// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/output/core_strain.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

enum Component { xx, yy, zz, yz, xz, xy };

} // namespace

CoreStrain mirrored(CoreStrain strain, const std::array<bool, 2>& reflect) {
  const auto [nx, ny, nz] = strain.points;
  const double x_sign = reflect[0] ? -1 : 1, y_sign = reflect[1] ? -1 : 1;
  for (int c = 0; c < 6; ++c) {
    const double sign = c == xy ? x_sign * y_sign : c == xz ? x_sign : c == yz ? y_sign : 1.0;
    if (strain.component[c].empty()) {
      continue;
    }
    double* row = strain.component[c].data();
    for (std::size_t k = 0; k < nz; ++k) {
      for (std::size_t j = 0; reflect[1] && j < ny / 2; ++j) {
        std::swap_ranges(row + j * nx, row + (j + 1) * nx, row + (ny - 1 - j) * nx);
      }
      for (std::size_t j = 0; j < ny; ++j, row += nx) {
        if (reflect[0]) {
          std::reverse(row, row + nx);
        }
        std::transform(row, row + nx, row, [sign](double value) { return sign * value; });
      }
    }
  }
  return strain;
}

double off_diagonal_shear_integral(const CoreStrain& strain, const mesh::MeshLines& lines,
                                   const std::array<std::size_t, 2>& core_z) {
  const auto [nx, ny, nz] = strain.points;
  double integral = 0;
  for (std::size_t k = 0; k < nz; ++k) {
    const std::size_t row = core_z[0] + k / 2;
    const double dz = (lines.z[row + 1] - lines.z[row]) / 2;
    for (std::size_t j = 0; j < ny; ++j) {
      const double dy = (lines.y[j / 2 + 1] - lines.y[j / 2]) / 2;
      for (std::size_t i = 0; i < nx; ++i) {
        const double dx = (lines.x[i / 2 + 1] - lines.x[i / 2]) / 2;
        const std::size_t at = i + nx * (j + ny * k);
        const double a = strain.component[xy][at], b = strain.component[yz][at],
                     c = strain.component[xz][at];
        integral += 2 * std::sqrt(a * a + b * b + c * c) * dx * dy * dz;
      }
    }
  }
  return integral;
}

} // namespace ionskin::mechanics
