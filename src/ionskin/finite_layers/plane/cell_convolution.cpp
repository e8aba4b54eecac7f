// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/cell_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

bool equally_wide(const std::vector<double>& lines) {
  constexpr double rounding = 1e-9;
  const double width = (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (std::abs(lines[i + 1] - lines[i] - width) > rounding * width) {
      return false;
    }
  }
  return true;
}

} // namespace

bool is_even(const ContactGrid& grid) {
  return equally_wide(grid.x) && equally_wide(grid.y);
}

CellConvolution::CellConvolution(const ContactGrid& grid)
    : grid_(grid), fourier_(grid.columns(), grid.rows()) {}

void CellConvolution::include(const PlaneCompliance& body, const std::vector<RowImage>& images,
                              double mixed) {
  const Eigen::Index columns = grid_.columns(), rows = grid_.rows();
  const double width = (grid_.x.back() - grid_.x.front()) / static_cast<double>(columns);
  const double height = (grid_.y.back() - grid_.y.front()) / static_cast<double>(rows);
  const Interval x_from{0, width}, y_from{0, height};
  for (const bool turned : {false, true}) {
    std::array<Eigen::MatrixXd, 6> values;
    values.fill(Eigen::MatrixXd::Zero(fourier_.columns(), fourier_.rows()));
    bool any = false;
    for (const RowImage& image : images) {
      if (image.mirrored != turned) {
        continue;
      }
      any = true;
      // Position along y of the first row of the grid, seen from the first row of the image.
      const double first = (turned ? grid_.y.front() + grid_.y.back() : 0.0) - image.shift;
      for (Eigen::Index j = 1 - rows; j < rows; ++j) {
        const double y = first + static_cast<double>(j) * height;
        for (Eigen::Index i = 1 - columns; i < columns; ++i) {
          const double x = static_cast<double>(i) * width;
          const CellCompliance at =
              plane_compliance(body, {x, x + width}, {y, y + height}, x_from, y_from);
          const std::array<double, 6> parts{at(0, 0), mixed * at(0, 1), mixed * at(0, 2),
                                            at(1, 1), at(1, 2),         at(2, 2)};
          const Eigen::Index column = i < 0 ? i + fourier_.columns() : i,
                             row = j < 0 ? j + fourier_.rows() : j;
          for (std::size_t part = 0; part < parts.size(); ++part) {
            values[part](column, row) += parts[part];
          }
        }
      }
    }
    if (!any) {
      continue;
    }
    Kernel& kernel = turned ? mirrored_ : direct_;
    for (std::size_t part = 0; part < values.size(); ++part) {
      const GridFourier::Spectrum spectrum = fourier_.forward(values[part]);
      kernel[part] = kernel[part].size() == 0 ? spectrum : kernel[part] + spectrum;
    }
    for (std::size_t c = 0; c < 3 && !turned; ++c) {
      own_[c] += values[std::array<std::size_t, 3>{0, 3, 5}[c]](0, 0);
    }
  }
}

/// Spectrum of the forces with their rows in the opposite order.
GridFourier::Spectrum CellConvolution::mirrored(const GridFourier::Spectrum& of_forces) const {
  const Eigen::Index waves = of_forces.rows();
  GridFourier::Spectrum result(waves, of_forces.cols());
  for (Eigen::Index k = 0; k < waves; ++k) {
    const Eigen::Index turns = k * (grid_.rows() - 1) % waves;
    const double angle =
        -2 * std::numbers::pi * static_cast<double>(turns) / static_cast<double>(waves);
    result.row(k) = std::polar(1.0, angle) * of_forces.row(k == 0 ? 0 : waves - k);
  }
  return result;
}

void CellConvolution::add_product(const Kernel& kernel,
                                  const std::array<GridFourier::Spectrum, 3>& forces,
                                  std::array<GridFourier::Spectrum, 3>& sum) {
  sum[0] += kernel[0] * forces[0] + kernel[1] * forces[1] + kernel[2] * forces[2];
  sum[1] += kernel[3] * forces[1] + kernel[4] * forces[2] - kernel[1] * forces[0];
  sum[2] += kernel[4] * forces[1] + kernel[5] * forces[2] - kernel[2] * forces[0];
}

void CellConvolution::add(const CellFields& forces, CellFields& displacements) const {
  std::array<GridFourier::Spectrum, 3> of_forces, sum;
  for (std::size_t c = 0; c < 3; ++c) {
    of_forces[c] = fourier_.forward(forces[c]);
    sum[c] = GridFourier::Spectrum::Zero(of_forces[c].rows(), of_forces[c].cols());
  }
  add_product(direct_, of_forces, sum);
  if (mirrored_[0].size() > 0) {
    for (GridFourier::Spectrum& one : of_forces) {
      one = mirrored(one);
    }
    of_forces[2] *= -1; // a mirrored force along y is the opposite one
    add_product(mirrored_, of_forces, sum);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    displacements[c] += fourier_.back(sum[c], grid_.columns(), grid_.rows());
  }
}

} // namespace ionskin::finite_layers
