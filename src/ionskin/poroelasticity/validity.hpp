// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <string>
#include <vector>

namespace ionskin::poroelasticity {

/// Boundary condition that the slider imposes on the skin while water redistributes in the core:
/// duration of the contact, and held position or held force.
struct Holding {
  double time = 0;       ///< longest unbroken contact [s]; 0 without a slider
  bool by_force = false; ///< true if all contact is under force control; false: held indentation
  double number = 0; ///< c_v time / h^2, dimensionless time of the water diffusion through the core
};
/// Derives the longest contact of a case from the motion of the slider.
Holding holding(const Case& input);

/// Relative error of signals that pressure drives [1], caused by a strain that does not follow the
/// water (decoupled poroelasticity). It is the error of the pressure difference between the walls,
/// and at late times of the dilution, compared with the full Biot equations in plane strain. It is
/// interpolated at the `Holding::number` of the case in a table of the worse of Poisson's ratios
/// 0.3 and 0.4 (docs/errors-of-results.md). 0 if the strain is prescribed or read from a file.
double decoupling_error(const Case& input);

/// Warnings about a case outside the range of validity of the coupling law `poroelastic`: sentences
/// with the number, the reason and the remedy; empty if there is nothing to warn about. They follow
/// from the case alone, before a run.
/// @param input checked case whose coupling law moves water
std::vector<std::string> validity_warnings(const Case& input);

/// Drive |g| above which a run warns, because the constants of the core at rest no longer apply
/// [1].
inline constexpr double largest_sound_drive = 0.5;

} // namespace ionskin::poroelasticity
