// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/lateral_flux.hpp"

#include <algorithm>

namespace ionskin::electrochemistry {
namespace {

struct Face {
  double ions = 0;
  double field = 0;
};

/// Ions that flow into column a from column b, driven by p.
inline double ions_into(const double* c, const double* p, std::size_t a, std::size_t b) {
  return (c[b] - c[a]) + 0.5 * (c[a] + c[b]) * (p[b] - p[a]);
}

inline double change_of_ions_into(const double* c, const double* p, const double* dc,
                                  const double* dp, std::size_t a, std::size_t b) {
  return (dc[b] - dc[a]) +
         0.5 * ((dc[a] + dc[b]) * (p[b] - p[a]) + (c[a] + c[b]) * (dp[b] - dp[a]));
}

} // namespace

LateralFlux::LateralFlux(const ScaledGrid& grid)
    : columns_x_(grid.columns_x), columns_y_(grid.columns_y), coupling_x_(grid.coupling_x),
      coupling_y_(grid.coupling_y), ions_x_(grid.columns_x + 1, 0.0),
      field_x_(grid.columns_x + 1, 0.0), ions_before_(grid.columns_x),
      field_before_(grid.columns_x), ions_behind_(grid.columns_x), field_behind_(grid.columns_x) {}

/// Sums the fluxes into every column; `face(a, b)` is the flux into column a from its neighbour b,
/// without the factor g.
template <class FaceFlux>
void LateralFlux::sum_faces(const FaceFlux& face, std::span<double> ions, std::span<double> field) {
  std::fill(ions_before_.begin(), ions_before_.end(), 0.0);
  std::fill(field_before_.begin(), field_before_.end(), 0.0);
  for (std::size_t j = 0; j < columns_y_; ++j) {
    const std::size_t row = j * columns_x_;
    double* ions_x = ions_x_.data();
    double* field_x = field_x_.data();
#pragma omp simd
    for (std::size_t i = 0; i < columns_x_ - 1; ++i) {
      const Face flux = face(row + i, row + i + 1);
      ions_x[i + 1] = coupling_x_ * flux.ions;
      field_x[i + 1] = coupling_x_ * flux.field;
    }
    if (j + 1 < columns_y_) {
      double* ions_y = ions_behind_.data();
      double* field_y = field_behind_.data();
#pragma omp simd
      for (std::size_t i = 0; i < columns_x_; ++i) {
        const Face flux = face(row + i, row + columns_x_ + i);
        ions_y[i] = coupling_y_ * flux.ions;
        field_y[i] = coupling_y_ * flux.field;
      }
    } else {
      std::fill(ions_behind_.begin(), ions_behind_.end(), 0.0);
      std::fill(field_behind_.begin(), field_behind_.end(), 0.0);
    }
#pragma omp simd
    for (std::size_t i = 0; i < columns_x_; ++i) {
      ions[row + i] = (ions_x[i + 1] - ions_x[i]) + (ions_behind_[i] - ions_before_[i]);
      field[row + i] = (field_x[i + 1] - field_x[i]) + (field_behind_[i] - field_before_[i]);
    }
    ions_before_.swap(ions_behind_);
    field_before_.swap(field_behind_);
  }
}

void LateralFlux::inflow(std::span<const double> concentration, std::span<const double> drive,
                         std::span<const double> potential, std::span<double> ions,
                         std::span<double> field) {
  const double* c = concentration.data();
  const double* p = drive.data();
  const double* phi = potential.data();
  sum_faces(
      [c, p, phi](std::size_t a, std::size_t b) {
        return Face{ions_into(c, p, a, b), phi[b] - phi[a]};
      },
      ions, field);
}

void LateralFlux::inflow_change(std::span<const double> concentration,
                                std::span<const double> drive,
                                std::span<const double> d_concentration,
                                std::span<const double> d_drive,
                                std::span<const double> d_potential, std::span<double> ions,
                                std::span<double> field) {
  const double* c = concentration.data();
  const double* p = drive.data();
  const double* dc = d_concentration.data();
  const double* dp = d_drive.data();
  const double* dphi = d_potential.data();
  sum_faces(
      [c, p, dc, dp, dphi](std::size_t a, std::size_t b) {
        return Face{change_of_ions_into(c, p, dc, dp, a, b), dphi[b] - dphi[a]};
      },
      ions, field);
}

} // namespace ionskin::electrochemistry
