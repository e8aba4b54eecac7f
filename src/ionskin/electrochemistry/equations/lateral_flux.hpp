// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Central fluxes between neighbouring columns of one level, whose spacing is hundreds of Debye
/// lengths, with no flux through the sides of the core:
///   inflow of ions = sum over neighbours of g (c_n - c + (c_n + c)/2 (psi_n - psi)),
///   inflow of the field = sum over neighbours of g (phi_n - phi),   g = 1 / width^2,
/// where psi, which drives the ions, is phi or the sum of phi and an excess.
/// Each face flux is computed once and used by both columns, so that nothing is lost between them.
class LateralFlux {
public:
  explicit LateralFlux(const ScaledGrid& grid);

  /// One value per column in all spans.
  /// @param drive of the ions: the potential, or the sum of it and an excess
  void inflow(std::span<const double> concentration, std::span<const double> drive,
              std::span<const double> potential, std::span<double> ions, std::span<double> field);

  /// Change of `inflow` with a change (d_concentration, d_drive, d_potential) of its arguments.
  void inflow_change(std::span<const double> concentration, std::span<const double> drive,
                     std::span<const double> d_concentration, std::span<const double> d_drive,
                     std::span<const double> d_potential, std::span<double> ions,
                     std::span<double> field);

private:
  template <class FaceFlux>
  void sum_faces(const FaceFlux& face, std::span<double> ions, std::span<double> field);

  std::size_t columns_x_, columns_y_;
  double coupling_x_, coupling_y_;
  // Face fluxes of one row along x, and of the row of faces before and behind it along y.
  std::vector<double> ions_x_, field_x_, ions_before_, field_before_, ions_behind_, field_behind_;
};

} // namespace ionskin::electrochemistry
