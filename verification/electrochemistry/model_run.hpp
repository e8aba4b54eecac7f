// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "verification_table.hpp"

#include <cstddef>

namespace ionskin::verification {

/// F c0 lambda of the baseline [C/m2] and the area of its electrodes [m2].
inline constexpr double charge_density = 76.4835, electrode_area = 15e-3 * 2e-3;

electrochemistry::IonSolution run_model(const Case& input, const history::CoreHistory& history,
                                        const Options& options);

/// (Q_top - Q_bottom) / 2 of a row [C].
double charge_difference(const electrochemistry::IonSolution& solution, std::size_t row);

/// The row at an instant on which the steps land [s].
std::size_t row_at(const electrochemistry::IonSolution& solution, double time);

} // namespace ionskin::verification
