// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/circuits/instrument_reading.hpp"
#include "ionskin/laws/law_parameter.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::circuits {

/// A resistor and a capacitor in parallel between the electrodes: with the voltage
/// U = phi_top - phi_bottom and the difference current I = d((Q_top - Q_bottom)/2)/dt, positive
/// into the top electrode, I = -U/R - C dU/dt (docs/model.md (31)). The common
/// current returns through the ground and does not pass the circuit.
struct Admittance {
  double resistance = std::numeric_limits<double>::infinity(); ///< R [ohm]
  double capacitance = 0;                                      ///< C [F]

  /// True if a charge can pass at all.
  bool passes_charge() const;
};

/// White noise at the input of an instrument that has keys of its own.
struct InputNoise {
  double current = 0;   ///< density, one-sided [A/sqrt(Hz)]
  double bandwidth = 0; ///< of its first-order low pass, -3 dB [Hz]
};

/// A circuit with the values of its parameters.
struct Circuit {
  std::string_view name{};
  std::string words{}; ///< name without an article: "resistor of 1000 ohm"
  /// Admittance between the electrodes; nothing where the circuit holds both at one potential.
  std::optional<Admittance> admittance{};
  /// Reading of the circuit's instrument for the difference charge [C] over time [s]; empty without
  /// one.
  std::function<InstrumentReading(const std::vector<double>& time,
                                  const std::vector<double>& charge)>
      read{};
  /// Noise of the circuit's own instrument; nothing where `readout.instrument` reads.
  std::optional<InputNoise> input_noise{};
};

/// One row of the table of circuits.
struct CircuitRow {
  std::string_view name;    ///< value of `readout.circuit`
  std::string_view meaning; ///< part that joins the electrodes: "a load resistor"
  bool holds_potential;     ///< keeps both electrodes at one potential
  std::string_view noise;   ///< the parameter that is 0 without noise; empty for a quiet circuit
  std::span<const laws::LawParameter> parameters; ///< keys `readout.NAME`
  Circuit (*with)(const laws::LawValues& values);
};

/// All circuits; the first is the default of a case.
std::span<const CircuitRow> circuits();

/// The row of a name that the schema has checked.
const CircuitRow& circuit_row(std::string_view name);

/// The circuit of a name that the schema has checked. Throws std::out_of_range where a value of its
/// parameters is missing.
Circuit circuit(std::string_view name, const laws::LawValues& values);

/// Condition on the potential of the top electrode above the bottom one, for drawings: "φ = U = R
/// I".
std::string_view top_potential(const Circuit& circuit);

} // namespace ionskin::circuits
