// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/core_strain.hpp"

#include "ionskin/mechanics/elastic_system.hpp"

#include <Eigen/Core>

#include <cmath>

namespace ionskin::mechanics {
namespace {

enum Component { xx, yy, zz, yz, xz, xy };

/// Derivatives along x, y, z at every Gauss point [8 points x 3] by node.
using GradientMatrix = Eigen::Matrix<double, 3 * strain_points, element_nodes>;
/// Displacement of every node [27] by component.
using NodalDisplacement = Eigen::Matrix<double, element_nodes, 3>;
/// Row 3 q + r, column c: du_c/dx_r at point q of the unit cube.
using UnitGradients = Eigen::Matrix<double, 3 * strain_points, 3>;

GradientMatrix gradient_matrix() {
  GradientMatrix matrix;
  for (int q = 0; q < strain_points; ++q) {
    for (int i = 0; i < element_nodes; ++i) {
      for (int r = 0; r < 3; ++r) {
        matrix(3 * q + r, i) = reference_element().strain_gradient[q][i][r];
      }
    }
  }
  return matrix;
}

NodalDisplacement nodal_displacement(const ElasticSpace& space, std::size_t element,
                                     const double* displacement) {
  NodalDisplacement local;
  for (int i = 0; i < element_nodes; ++i) {
    const std::array<int, 3>& unknown = space.unknown(space.nodes(element)[i]);
    for (int c = 0; c < 3; ++c) {
      local(i, c) = unknown[c] < 0 ? 0.0 : displacement[unknown[c]];
    }
  }
  return local;
}

void store(CoreStrain& strain, std::size_t at, const UnitGradients& gradients, int q,
           const std::array<double, 3>& size) {
  const auto derivative = [&](int c, int r) { return gradients(3 * q + r, c) / size[r]; };
  for (int c = 0; c < 3; ++c) {
    strain.component[c][at] = derivative(c, c);
  }
  strain.component[yz][at] = 0.5 * (derivative(1, 2) + derivative(2, 1));
  strain.component[xz][at] = 0.5 * (derivative(0, 2) + derivative(2, 0));
  strain.component[xy][at] = 0.5 * (derivative(0, 1) + derivative(1, 0));
}

} // namespace

std::vector<CoreStrain> core_strain(const ElasticSpace& space, const mesh::MeshLines& lines,
                                    const std::array<std::size_t, 2>& core_z,
                                    const linear_algebra::DenseMatrix& displacement) {
  const auto [nx, ny, nz] = space.elements();
  CoreStrain empty;
  empty.points = {2 * nx, 2 * ny, 2 * (core_z[1] - core_z[0])};
  empty.component.fill(std::vector<double>(empty.points[0] * empty.points[1] * empty.points[2]));
  std::vector<CoreStrain> result(static_cast<std::size_t>(displacement.columns), empty);
  const GradientMatrix gradient = gradient_matrix();
  for (int state = 0; state < displacement.columns; ++state) {
    for (std::size_t e = nx * ny * core_z[0]; e < nx * ny * core_z[1]; ++e) {
      const UnitGradients gradients =
          gradient.lazyProduct(nodal_displacement(space, e, displacement.column(state)));
      const std::array<double, 3> size = element_size(space, lines, e);
      const std::size_t i = 2 * (e % nx), j = 2 * (e / nx % ny),
                        k = 2 * (e / (nx * ny) - core_z[0]);
      for (std::size_t q = 0; q < strain_points; ++q) {
        const std::size_t at =
            i + q % 2 + empty.points[0] * (j + q / 2 % 2 + empty.points[1] * (k + q / 4));
        store(result[state], at, gradients, static_cast<int>(q), size);
      }
    }
  }
  return result;
}

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
