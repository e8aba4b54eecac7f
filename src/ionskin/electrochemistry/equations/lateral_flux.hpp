// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Lateral inflow of ions and of field into every column of one z level, by central differences
/// between neighbouring columns, which are hundreds of Debye lengths wide; nothing passes the sides
/// of the core:
///   inflow of ions = sum over neighbours of g (c_n - c + (c_n + c)/2 (psi_n - psi)),
///   inflow of the field = sum over neighbours of g (phi_n - phi),   g = 1 / width^2,
/// where psi, which drives the ions, is phi or the sum of phi and an excess. All values are scaled.
/// Each face flux is computed once and used by both columns, so that nothing is lost between them.
class LateralFlux {
public:
  explicit LateralFlux(const ScaledGrid& grid);

  /// Computes the inflows. All spans hold one value per column.
  /// @param drive psi, the potential that drives the ions: phi, or its sum with an excess
  /// @param potential phi
  /// @param ions, field receive the inflow of ions and of the field
  void inflow(std::span<const double> concentration, std::span<const double> drive,
              std::span<const double> potential, std::span<double> ions, std::span<double> field);

  /// Computes the change of the inflows with a change (d_concentration, d_drive, d_potential) of
  /// the arguments of `inflow`.
  void inflow_change(std::span<const double> concentration, std::span<const double> drive,
                     std::span<const double> d_concentration, std::span<const double> d_drive,
                     std::span<const double> d_potential, std::span<double> ions,
                     std::span<double> field);

private:
  template <class FaceFlux>
  void sum_faces(const FaceFlux& face, std::span<double> ions, std::span<double> field);

  std::size_t columns_x_, columns_y_;
  double coupling_x_, coupling_y_;
  // Fluxes through the faces of one row of columns along x, and through its faces before and behind
  // it along y.
  std::vector<double> ions_x_, field_x_, ions_before_, field_before_, ions_behind_, field_behind_;
};

} // namespace ionskin::electrochemistry
