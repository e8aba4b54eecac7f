// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/instruments.hpp"

#include "ionskin/laws/named_row.hpp"

#include <array>
#include <cmath>

namespace ionskin::circuits {

std::span<const Instrument> instruments() {
  // The AD8605's voltage noise is that of the first page of its data sheet (revisions I to N). The
  // OPA140's, and both current noises, are written from memory of the tables of the data sheets and
  // not compared with them; SBOS498F calls the OPA140's current noise negligible for any practical
  // source impedance.
  static constexpr std::array rows{
      Instrument{
          "ad8605", "an AD8605 amplifier and a 16-bit converter", 8e-9, 10e-15, 16,
          "Analog Devices, data sheet AD8605/AD8606/AD8608: 8 nV/sqrt(Hz), 0.01 pA/sqrt(Hz)"},
      Instrument{"opa140", "an OPA140 amplifier and a 24-bit converter", 5.1e-9, 0.8e-15, 24,
                 "Texas Instruments, data sheet SBOS498: 5.1 nV/sqrt(Hz), 0.8 fA/sqrt(Hz)"},
      Instrument{"ideal", "an instrument without noise of its own", 0, 0, 0,
                 "what the skin itself leaves: its thermal noise"},
  };
  return rows;
}

const Instrument& instrument(std::string_view name) {
  return laws::named_row(instruments(), name, "instrument");
}

double quantisation_noise(const Instrument& instrument, double peak) {
  if (instrument.bits == 0 || !(peak > 0)) {
    return 0;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(peak)));
  double range = 10 * decade;
  for (const double step : {5.0, 2.0, 1.0}) {
    if (peak <= step * decade) {
      range = step * decade;
    }
  }
  return 2 * range / std::ldexp(1.0, instrument.bits) / std::sqrt(12.0);
}

} // namespace ionskin::circuits
