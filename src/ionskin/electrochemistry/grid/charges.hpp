// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Charge on the metal per area of each column, docs/model.md (25), scaled by F c0 lambda: what
/// Poisson's equation leaves over in the half control volume at the wall. It is conservative (the
/// two walls and the charge in between add up to nothing but rounding), where a difference of phi
/// at the wall is not. Where the potential of a wall is not
/// uniform, field passes from one control volume to the next.
struct WallCharges {
  std::vector<double> bottom, top;        ///< [y][x]
  double total_bottom = 0, total_top = 0; ///< sums over the columns
};

/// Charges on both walls of a state, resized to the columns.
/// @param fixed_charge cf / c0
void wall_charges(const ScaledGrid& grid, const IonState& state,
                  std::span<const double> fixed_charge, WallCharges& charges);

/// Integral of zeta/h over the charge that a unit ion density at a level stands for.
double ramo_weight(const ScaledGrid& grid, std::size_t level);

/// The top charge by the theorem of Ramo (1939, doi 10.1109/JRPROC.1939.228757) and Shockley (1938,
/// doi 10.1063/1.1710367), docs/model.md (27), summed over the columns, scaled like `wall_charges`:
///   Q_top = integral((zeta/h)(cf - v c)) + (phi_top - phi_bottom)/h.
double ramo_charge_top(const ScaledGrid& grid, const IonState& state,
                       std::span<const double> fixed_charge);

} // namespace ionskin::electrochemistry
