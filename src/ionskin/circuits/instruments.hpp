// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace ionskin::circuits {

/// Instrument that reads the electrodes: an amplifier, that holds a current input at one potential
/// or follows a voltage, and a converter of so many bits over the least range, 1, 2 or 5 times a
/// power of ten to either side, that the signal fits in.
struct Instrument {
  std::string_view name;    ///< value of `readout.instrument`
  std::string_view meaning; ///< as in "read by an AD8605 amplifier and a 16-bit converter"
  double voltage_noise = 0; ///< input-referred, one-sided, white [V/sqrt(Hz)]
  double current_noise = 0; ///< likewise [A/sqrt(Hz)]
  int bits = 0;             ///< of the converter; 0 for one without steps
  std::string_view source;  ///< of the figures
};

/// All instruments; the first is the default of a case.
std::span<const Instrument> instruments();

/// The instrument of a name that the schema has checked.
const Instrument& instrument(std::string_view name);

/// Rms that a converter's steps leave of a signal in the least range that it fits in.
/// @param peak of the signal, positive
double quantisation_noise(const Instrument& instrument, double peak);

} // namespace ionskin::circuits
