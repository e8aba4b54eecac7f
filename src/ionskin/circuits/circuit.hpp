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

/// Admittance of the circuit between the electrodes: a resistor and a capacitor in parallel. With
/// the voltage U = phi_top - phi_bottom and the difference current I = d((Q_top - Q_bottom)/2)/dt,
/// positive into the top electrode, I = -U/R - C dU/dt (docs/model.md (31)). The common current
/// d((Q_top + Q_bottom)/2)/dt returns through the ground and does not pass the circuit.
struct Admittance {
  /// R [ohm]; infinite without a resistor.
  double resistance = std::numeric_limits<double>::infinity();
  double capacitance = 0; ///< C [F]; 0 without a capacitor

  /// True if the circuit passes any charge: R is finite or C is above 0.
  bool passes_charge() const;
};

/// White current noise at the input of an instrument that is part of the circuit, such as an
/// amplifier.
struct InputNoise {
  double current = 0;   ///< one-sided density [A/sqrt(Hz)]
  double bandwidth = 0; ///< -3 dB bandwidth of the instrument's first-order low pass [Hz]
};

/// Readout circuit with the values of its parameters, made by `circuit(name, values)`.
struct Circuit {
  std::string_view name{}; ///< value of `readout.circuit`
  std::string words{};     ///< description without an article, for messages: "resistor of 1000 ohm"
  /// Admittance between the electrodes; nothing where the circuit holds both electrodes at one
  /// potential.
  std::optional<Admittance> admittance{};
  /// Function that computes the reading of the circuit's own instrument from the instants `time`
  /// [s] and the difference charge (Q_top - Q_bottom)/2 [C], one value per row each. Empty for a
  /// circuit without an instrument of its own.
  std::function<InstrumentReading(const std::vector<double>& time,
                                  const std::vector<double>& charge)>
      read{};
  /// Input noise of the circuit's own instrument; nothing where the instrument `readout.instrument`
  /// reads the electrodes.
  std::optional<InputNoise> input_noise{};
};

/// Row of the table of readout circuits: name, keys and factory of one circuit.
struct CircuitRow {
  std::string_view name; ///< value of `readout.circuit`
  /// Connection between the electrodes, with an article: "a load resistor".
  std::string_view meaning;
  bool holds_potential; ///< true if it keeps both electrodes at one potential
  /// Name of the parameter that is 0 without noise; empty for a circuit without noise.
  std::string_view noise;
  std::span<const laws::LawParameter> parameters; ///< its parameters, the keys `readout.NAME`
  /// Makes the circuit from the values of its parameters [SI], without `Circuit::name`.
  Circuit (*with)(const laws::LawValues& values);
};

/// Table of all readout circuits; the first row is the default of a case.
std::span<const CircuitRow> circuits();

/// Finds the row of a circuit by its name, which the schema has checked. Throws InternalError when
/// there is none.
const CircuitRow& circuit_row(std::string_view name);

/// Makes a circuit by its name, which the schema has checked, with values of its parameters [SI].
/// Throws InternalError when no circuit has the name, and std::out_of_range when the value of a
/// parameter is missing.
Circuit circuit(std::string_view name, const laws::LawValues& values);

/// Boundary condition on the potential φ of the top electrode against the bottom one, as a label
/// for drawings: "φ = U = R I".
std::string_view top_potential(const Circuit& circuit);

} // namespace ionskin::circuits
