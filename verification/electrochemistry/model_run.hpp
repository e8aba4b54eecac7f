// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "verification_table.hpp"

#include <cstddef>

namespace ionskin::verification {

/// Charge per area F c0 lambda of the baseline case [C/m2], and the area of its electrodes [m2].
inline constexpr double charge_density = 76.4835, electrode_area = 15e-3 * 2e-3;

/// Solves the ion transport (Study 2) of a case under a given strain history.
electrochemistry::IonSolution run_model(const Case& input, const history::CoreHistory& history,
                                        const Options& options);

/// Difference charge (Q_top - Q_bottom)/2 in a row of a solution [C].
double charge_difference(const electrochemistry::IonSolution& solution, std::size_t row);

/// Index of the row of a solution at an instant [s]. Throws InternalError when no time step ends
/// there.
std::size_t row_at(const electrochemistry::IonSolution& solution, double time);

} // namespace ionskin::verification
