// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <string>
#include <vector>

namespace ionskin::poroelasticity {

/// Hold of the slider on the skin while water moves.
struct Holding {
  double time = 0;       ///< longest unbroken contact [s]; 0 without a slider
  bool by_force = false; ///< force control throughout, else an indentation
  double number = 0;     ///< c_v time/h2: how far the water gets meanwhile [1]
};
Holding holding(const Case& input);

/// Error that the strain, which does not follow the water, leaves in signals that pressure makes,
/// over their value [1]: the error of the wall difference of P against full Biot equations in plane
/// strain, and late that of the dilution, at the case's `Holding::number`, by a table of the worse
/// of Poisson's ratios 0.3 and 0.4 (docs/errors-of-results.md). 0 where the strain is prescribed or
/// from a file.
double decoupling_error(const Case& input);

/// Warnings where a case leaves what the law holds for: sentences with number, reason and remedy,
/// of a checked case whose law moves water. What follows from the case alone, before a run.
std::vector<std::string> validity_warnings(const Case& input);

/// Drive g above which a run warns: constants of the core at rest no longer serve.
inline constexpr double largest_sound_drive = 0.5;

} // namespace ionskin::poroelasticity
