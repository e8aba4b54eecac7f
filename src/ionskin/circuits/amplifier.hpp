// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/circuit.hpp"

#include <array>

namespace ionskin::circuits {

/// Transimpedance amplifier as readout circuit. It holds both electrodes at one potential and shows
/// the difference current I = d((Q_top - Q_bottom)/2)/dt through a first-order low pass, y' = (I -
/// y)/tau with tau = 1/(2 pi bandwidth), plus white input noise behind the same low pass, clipped
/// at +-range. Source: a standard model of the instrument.
struct Amplifier {
  double bandwidth = 0; ///< -3 dB bandwidth of the first-order low pass [Hz]
  /// One-sided density of the input current noise [A/sqrt(Hz)]; 0 for none.
  double noise_density = 0;
  double range = 0;      ///< largest current shown, of either sign [A]; 0 for no limit
  double noise_seed = 0; ///< seed of the noise, a whole number

  static constexpr std::string_view meaning =
      "a transimpedance amplifier that reads the short-circuit current";
  static constexpr std::string_view noise = "amplifier_noise_density";
  static constexpr auto parameters() {
    using Own = laws::OwnParameter<Amplifier>;
    return std::array{
        Own{{.name = "amplifier_bandwidth",
             .dimension = units::Dimension::frequency,
             .lowest = 1e-6,
             .highest = 1e12,
             .help = "Bandwidth (-3 dB) of the amplifier's first-order low pass.",
             .default_value = "\"1 kHz\"",
             .source = "an assumption: passes contact events of a millisecond"},
            &Amplifier::bandwidth},
        Own{{.name = noise,
             .dimension = units::Dimension::current_noise_density,
             .lowest = 0,
             .highest = 1,
             .help = "Input-referred white current noise density of the amplifier, one-sided.",
             .default_value = "\"0 A/sqrt(Hz)\"",
             .source = "an ideal amplifier"},
            &Amplifier::noise_density},
        Own{{.name = "amplifier_range",
             .dimension = units::Dimension::current,
             .lowest = 0,
             .highest = 1e3,
             .help =
                 "Largest current that the amplifier can show, of either sign; beyond it clips. "
                 "0 A: any.",
             .default_value = "\"0 A\"",
             .source = "an ideal amplifier"},
            &Amplifier::range},
        Own{{.name = "noise_seed",
             .whole = true,
             .lowest = 0,
             .highest = 2147483647,
             .help = "Seed of the amplifier's noise: the same seed gives the same noise.",
             .default_value = "1"},
            &Amplifier::noise_seed}};
  }
  std::string words() const;
  /// Computes what the amplifier shows at every row of a run. The low pass is solved exactly for an
  /// input current that is constant over each step. Charge in row 0 is an impulse: y starts at
  /// charge/tau. `charge` of the result is the integral of the clipped output; the noise within a
  /// step is clipped as a whole. The figures are the largest current shown [A] and the time in
  /// which the output is beyond the range [s]; a warning reports clipping.
  /// @param time instants of the rows, ascending and not empty [s]
  /// @param charge (Q_top - Q_bottom)/2 under short circuit, one value per row [C]
  InstrumentReading read(const std::vector<double>& time, const std::vector<double>& charge) const;
  InputNoise input_noise() const { return {noise_density, bandwidth}; }
};

} // namespace ionskin::circuits
