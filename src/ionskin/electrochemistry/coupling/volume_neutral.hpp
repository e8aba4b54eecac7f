// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <span>

namespace ionskin::electrochemistry {

/// Coupling law `volume-neutral`: shear moves fixed charge within the core,
///   cf / c0 = 1 + k (gamma - mean of gamma over the core).
/// Conserves the total fixed charge: the volume mean of cf stays c0, so the two electrodes carry
/// opposite charges. Source: the neutral reading of the `fixed-charge` law, as electroneutrality of
/// an isolated core demands (Gauss).
/// @param coefficient k [1]
/// @param shear gamma on the transport grid [1]
/// @param ratio receives cf / c0 [1]
void apply_volume_neutral(double coefficient, const ScaledGrid& grid, std::span<const double> shear,
                          std::span<double> ratio);

} // namespace ionskin::electrochemistry
