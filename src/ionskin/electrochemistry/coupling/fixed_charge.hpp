// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace ionskin::electrochemistry {

/// Coupling law `fixed-charge`: shear creates fixed charge in place,
///   cf / c0 = 1 + k gamma.
/// The mobile ions are kept in by blocking electrodes, so the core gains the net charge
/// F c0 k integral(gamma dV), which both electrodes together answer at once (Gauss).
/// Source: the law of the skin model that ionskin reproduces (its equation 26).
/// @param coefficient k [1]
/// @param shear gamma on the transport grid [1]
/// @param ratio receives cf / c0 [1]
void apply_fixed_charge(double coefficient, std::span<const double> shear, std::span<double> ratio);

} // namespace ionskin::electrochemistry
