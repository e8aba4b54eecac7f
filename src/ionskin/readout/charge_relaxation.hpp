// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::readout {

/// Charge of the ion transport between its rows: the part of half the difference of the electrodes'
/// charges that relaxes smoothly, and its rate at the rows. Empty where nothing is known.
struct ChargeRelaxation {
  std::vector<double> charge;  ///< [C]
  std::vector<double> current; ///< [A]
};

/// Departure of that part from the straight line between the rows at an instant [C]: by the cubic
/// with the values and rates of the rows (Hermite), 0 on the rows and outside them. Steps are a few
/// per cent of the relaxation time of the core, so that on straight lines a current sampled within
/// them would be some per cent off.
/// @param time of the rows [s], strictly ascending
double departure_from_line(const std::vector<double>& time, const ChargeRelaxation& relaxation,
                           double instant);

} // namespace ionskin::readout
