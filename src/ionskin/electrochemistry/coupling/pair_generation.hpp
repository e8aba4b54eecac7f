// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace ionskin::electrochemistry {

/// Coupling law `pair-generation`: shear dissociates pairs, so that every fixed charge comes with a
/// mobile ion released at the same place,
///   cf / c0 = 1 + k gamma,   source of v c / c0 = d(k gamma)/dt.
/// The core stays neutral everywhere: the charges of the electrodes add up to nothing, and the
/// integral of v c follows that of cf exactly. What drives the current is the diffusion of the
/// released ions away from their fixed partners. Where shear recedes, pairs recombine. Source: the
/// `fixed-charge` law made to conserve charge, as a dissociation reaction demands.
/// @param coefficient k [1]
/// @param shear gamma on the transport grid [1]
/// @param ratio receives cf / c0, of which the departure from 1 is also what has been released [1]
void apply_pair_generation(double coefficient, std::span<const double> shear,
                           std::span<double> ratio);

} // namespace ionskin::electrochemistry
