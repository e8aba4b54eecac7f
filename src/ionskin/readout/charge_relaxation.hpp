// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::readout {

/// Part of half the difference of the electrodes' charges that relaxes smoothly, with its rate, at
/// the rows of a run. It serves to interpolate charges between the rows more exactly than linearly.
/// Empty where it is not known.
struct ChargeRelaxation {
  std::vector<double> charge;  ///< [row] [C]
  std::vector<double> current; ///< rate of `charge` [row] [A]
};

/// Departure of the relaxing charge from the straight line between the rows at an instant, by the
/// cubic with the values and rates of the rows (Hermite); 0 on the rows and outside them [C]. Time
/// steps are a few per cent of the relaxation time of the core, so that with straight lines a
/// current sampled within them would be some per cent off.
/// @param time of the rows [s], strictly ascending
/// @param instant [s]
double departure_from_line(const std::vector<double>& time, const ChargeRelaxation& relaxation,
                           double instant);

} // namespace ionskin::readout
