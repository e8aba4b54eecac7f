// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>

namespace ionskin::electrochemistry {

/// Coupling law `column-neutral`: shear moves fixed charge through the thickness only,
///   cf / c0 = 1 + k (gamma - mean of gamma through the thickness at the same x, y).
/// Conserves the fixed charge of every column, so the two electrodes carry opposite charges
/// everywhere. Source: the neutral reading of the `fixed-charge` law for a core that is thin
/// against the distances along it.
/// @param coefficient k [1]
/// @param shear gamma on the transport grid [1]
/// @param ratio receives cf / c0 [1]
void apply_column_neutral(double coefficient, const ScaledGrid& grid, std::span<const double> shear,
                          std::span<double> ratio);

} // namespace ionskin::electrochemistry
