// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace ionskin::circuits {

/// Noise and resolution of an instrument that reads the electrodes: an amplifier, which holds a
/// current input at one potential or follows a voltage, and an analogue-to-digital converter. The
/// converter uses the smallest range that the signal fits in: 1, 2 or 5 times a power of ten, of
/// either sign.
struct Instrument {
  std::string_view name; ///< value of `readout.instrument`
  /// Description, as in "read by an AD8605 amplifier and a 16-bit converter".
  std::string_view meaning;
  double voltage_noise = 0; ///< one-sided density of white voltage noise at the input [V/sqrt(Hz)]
  double current_noise = 0; ///< one-sided density of white current noise at the input [A/sqrt(Hz)]
  int bits = 0;             ///< resolution of the converter; 0 for no quantisation
  std::string_view source;  ///< source of these numbers
};

/// Table of all instruments; the first is the default of a case.
std::span<const Instrument> instruments();

/// Finds an instrument by its name, which the schema has checked. Throws InternalError when there
/// is none.
const Instrument& instrument(std::string_view name);

/// Rms noise by quantisation, 2 range/(2^bits sqrt(12)), in the unit of `peak`; 0 without
/// quantisation or signal.
/// @param peak largest magnitude of the signal, which chooses the range
double quantisation_noise(const Instrument& instrument, double peak);

} // namespace ionskin::circuits
