// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Charge per area on the metal of both electrodes in each lateral column [F c0 lambda],
/// docs/model.md (25): the residual of Poisson's equation in the half control volume at the wall.
/// It is conservative (the two walls and the charge in between add up to nothing but rounding),
/// where a difference of phi at the wall is not. Where the potential of a wall is not uniform,
/// field that passes sideways between control volumes counts, too.
struct WallCharges {
  std::vector<double> bottom, top;        ///< [y][x]
  double total_bottom = 0, total_top = 0; ///< sums over the columns
};

/// Computes the charges on both walls of a state into `charges`, whose vectors are resized to the
/// columns.
/// @param fixed_charge cf / c0 [nodes]
void wall_charges(const ScaledGrid& grid, const IonState& state,
                  std::span<const double> fixed_charge, WallCharges& charges);

/// Computes the weight of a z level in the theorem of Ramo: the integral of zeta/h over the charge
/// that a unit ion density at this level stands for [Debye lengths].
double ramo_weight(const ScaledGrid& grid, std::size_t level);

/// Computes the charge of the top electrode by the theorem of Ramo (1939, doi
/// 10.1109/JRPROC.1939.228757) and Shockley (1938, doi 10.1063/1.1710367), docs/model.md (27),
/// summed over the columns [F c0 lambda]:
///   Q_top = integral((zeta/h)(cf - v c)) + (phi_top - phi_bottom)/h.
/// @param fixed_charge cf / c0 [nodes]
double ramo_charge_top(const ScaledGrid& grid, const IonState& state,
                       std::span<const double> fixed_charge);

} // namespace ionskin::electrochemistry
