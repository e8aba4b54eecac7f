// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/inverse_waves.hpp"

#include <cmath>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

/// Mean of a wave over a cell per amplitude [1].
double mean_over_cell(double wave_number, double size) {
  const double half = 0.5 * wave_number * size;
  return half == 0 ? 1.0 : std::sin(half) / half;
}

} // namespace

InverseWaves::InverseWaves(const ContactGrid& grid, const std::vector<WavesOfBody>& bodies)
    : half_(grid.half), fourier_(grid.columns(), grid.rows()) {
  // Number of aliased waves that are added on either side; their values on the cells are identical.
  constexpr int orders = 1;
  const double width = grid.column(0).size(), height = grid.row(0).size(), area = width * height;
  const double step_x = 2 * std::numbers::pi / (width * static_cast<double>(fourier_.columns())),
               step_y = 2 * std::numbers::pi / (height * static_cast<double>(fourier_.rows()));
  const double least = 0.5 * std::min(step_x, step_y); // replaces wave number 0
  const Eigen::Index nx = fourier_.columns() / 2 + 1, ny = fourier_.rows();
  for (Eigen::ArrayXXd* part : {&normal_, &xx_, &xy_, &yy_}) {
    part->resize(ny, nx);
  }
  for (Eigen::Index i = 0; i < nx; ++i) {
    for (Eigen::Index j = 0; j < ny; ++j) {
      double normal = 0, xx = 0, xy = 0, yy = 0;
      for (int a = -orders; a <= orders; ++a) {
        for (int b = -orders; b <= orders; ++b) {
          const double kx = step_x * static_cast<double>(i + a * fourier_.columns());
          const double ky = step_y * static_cast<double>((2 * j > ny ? j - ny : j) + b * ny);
          const double share =
              std::pow(mean_over_cell(kx, width) * mean_over_cell(ky, height), 2) / area;
          const double k = std::max(least, std::hypot(kx, ky)), c = kx / k, s = ky / k;
          for (const WavesOfBody& body : bodies) {
            const WaveCompliance at = body(k);
            normal += share * at.normal;
            xx += share * (c * c * at.along + (1 - c * c) * at.across);
            xy += share * c * s * (at.along - at.across);
            yy += share * (s * s * at.along + (1 - s * s) * at.across);
          }
        }
      }
      const double determinant = xx * yy - xy * xy;
      normal_(j, i) = 1 / normal;
      xx_(j, i) = yy / determinant;
      xy_(j, i) = -xy / determinant;
      yy_(j, i) = xx / determinant;
    }
  }
}

/// Continues the values of a half grid by their mirror image, times `sign`, behind the last row.
Eigen::MatrixXd InverseWaves::whole(const Eigen::MatrixXd& half, double sign) const {
  if (!half_) {
    return half;
  }
  Eigen::MatrixXd result(half.rows(), 2 * half.cols());
  result << half, sign * half.rowwise().reverse();
  return result;
}

Eigen::MatrixXd InverseWaves::normal(const Eigen::MatrixXd& displacement) const {
  return fourier_.back(normal_ * fourier_.forward(whole(displacement, 1)), displacement.rows(),
                       displacement.cols());
}

std::array<Eigen::MatrixXd, 2>
InverseWaves::tangential(const std::array<Eigen::MatrixXd, 2>& displacement) const {
  const GridFourier::Spectrum x = fourier_.forward(whole(displacement[0], 1)),
                              y = fourier_.forward(whole(displacement[1], -1));
  const Eigen::Index columns = displacement[0].rows(), rows = displacement[0].cols();
  return {fourier_.back(xx_ * x + xy_ * y, columns, rows),
          fourier_.back(xy_ * x + yy_ * y, columns, rows)};
}

} // namespace ionskin::finite_layers
