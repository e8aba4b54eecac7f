// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/core_strain.hpp"

#include <cmath>

namespace ionskin::mechanics {
namespace {

enum Component { xx, yy, zz, yz, xz, xy };

} // namespace

CoreStrain mirrored(const CoreStrain& strain, const std::array<bool, 2>& reflect) {
  CoreStrain result = strain;
  const auto [nx, ny, nz] = strain.points;
  const double x_sign = reflect[0] ? -1 : 1, y_sign = reflect[1] ? -1 : 1;
  for (int c = 0; c < 6; ++c) {
    const double sign = c == xy ? x_sign * y_sign : c == xz ? x_sign : c == yz ? y_sign : 1.0;
    for (std::size_t k = 0; k < nz; ++k) {
      for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
          const std::size_t from_i = reflect[0] ? nx - 1 - i : i,
                            from_j = reflect[1] ? ny - 1 - j : j;
          result.component[c][i + nx * (j + ny * k)] =
              sign * strain.component[c][from_i + nx * (from_j + ny * k)];
        }
      }
    }
  }
  return result;
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
