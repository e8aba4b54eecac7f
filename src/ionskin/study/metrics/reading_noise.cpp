// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/reading_noise.hpp"

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/readout/circuit.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/study/metrics/sample_noise.hpp"
#include "ionskin/study/metrics/slip_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ionskin::study {
namespace {

/// Largest reading of the own instrument of a circuit, a mean over the readout interval behind its
/// bandwidth and within its range [A]; without the noise that the instrument draws, which is no
/// signal.
/// @param values of the parameters of the circuit
/// @param charge that passes the instrument [row] [C]
double largest_own_reading(const std::string& name, laws::LawValues values,
                           const std::vector<double>& time, const std::vector<double>& charge,
                           double interval) {
  if (const auto noise = values.find(circuits::circuit_row(name).noise); noise != values.end()) {
    noise->second = 0;
  }
  return readout::peak_magnitude(
      readout::sampled_reading(circuits::circuit(name, values), time, charge, interval)
          .mean_current);
}

/// Charge that the circuit of a conductor has passed [row] [C].
const std::vector<double>& passed_by(const electrochemistry::IonSolution& ions,
                                     const std::string& conductor) {
  using electrochemistry::SegmentCharge;
  const auto line = std::ranges::find(ions.lines, conductor, &SegmentCharge::name);
  return line != ions.lines.end()
             ? line->passed
             : std::ranges::find(ions.top_segments, conductor, &SegmentCharge::name)->passed;
}

double value_of(const std::vector<readout::Metric>& metrics, const std::string& name) {
  const auto found = std::ranges::find(metrics, name, &readout::Metric::name);
  return found == metrics.end() ? 0.0 : found->value;
}

/// Taxels that are conductors of their own, or lines of a crossbar, each with its circuit and all
/// parameters.
std::vector<Taxel> conductors_of(const Readout& readout) {
  std::vector<Taxel> conductors = readout.lines();
  for (Taxel& line : conductors) {
    line.parameters = readout.parameters;
  }
  for (std::size_t i = 0; i < readout.taxels.size() && !readout.is_crossbar(); ++i) {
    if (readout.has_own_circuit(i)) {
      conductors.push_back(readout.taxels[i]);
      conductors.back().circuit = readout.circuit_of(i);
      conductors.back().parameters = readout.parameters_of(i);
    }
  }
  return conductors;
}

/// The case of the cell below a conductor, read by the circuit of this conductor.
Case cell_below(const Case& input, const Taxel& conductor) {
  Case cell = input;
  cell.skin.length = conductor.upper[0] - conductor.lower[0];
  cell.skin.width = conductor.upper[1] - conductor.lower[1];
  cell.readout.circuit = conductor.circuit;
  cell.readout.parameters = conductor.parameters;
  return cell;
}

} // namespace

void add_noise_of_taxel(const Case& input, const MechanicsRecord& mechanics,
                        const electrochemistry::IonSolution& ions, Signals& signals) {
  const double record = ions.time.back() - ions.time.front();
  const std::vector<Taxel> conductors = conductors_of(input.readout);
  Taxel strongest;
  bool of_voltage = false;
  double peak = -1;
  for (const Taxel& conductor : conductors) {
    const bool has_voltage = !circuits::circuit_row(conductor.circuit).holds_potential;
    const std::string column = (has_voltage ? "voltage_" : "current_circuit_") + conductor.name;
    const double largest =
        circuits::circuit(conductor.circuit, conductor.parameters).read
            ? largest_own_reading(conductor.circuit, conductor.parameters, ions.time,
                                  passed_by(ions, conductor.name), input.readout.sample_interval)
            : readout::peak_magnitude(signals.sampled_taxels->column(column).values);
    if (has_voltage > of_voltage || (has_voltage == of_voltage && largest > peak)) {
      strongest = conductor, of_voltage = has_voltage, peak = largest;
    }
  }
  const SampleNoise noise = sample_noise(cell_below(input, strongest), peak, record);
  const auto area = [](const Taxel& of) {
    return (of.upper[0] - of.lower[0]) * (of.upper[1] - of.lower[1]);
  };
  constexpr double rounding = 1e-9;
  double squares = 0;
  for (const Taxel& conductor : conductors) {
    // Taxels of a grid are alike: one noise stands for all that have its circuit.
    const bool alike = conductor.circuit == strongest.circuit &&
                       conductor.parameters == strongest.parameters &&
                       std::abs(area(conductor) - area(strongest)) < rounding * area(strongest);
    const Case cell = cell_below(input, alike ? strongest : conductor);
    const double own = current_noise(cell, alike ? noise : sample_noise(cell, peak, record));
    squares += input.readout.is_crossbar() && conductor.name.starts_with('r') ? 0.0 : own * own;
  }
  for (const auto& found :
       {precursor_metrics(input, mechanics, signals.resolved, std::sqrt(squares)),
        noise_metrics(noise, peak, of_voltage ? "V" : "A")}) {
    signals.metrics.insert(signals.metrics.end(), found.begin(), found.end());
  }
}

void add_noise(const Case& input, const MechanicsRecord& mechanics,
               const electrochemistry::IonSolution& ions, Signals& signals) {
  const circuits::Circuit circuit =
      circuits::circuit(input.readout.circuit, input.readout.parameters);
  const bool of_voltage = circuit.admittance.has_value();
  const double peak =
      circuit.read
          ? largest_own_reading(input.readout.circuit, input.readout.parameters, ions.time,
                                readout::charge_difference(ions.charge_top, ions.charge_bottom),
                                input.readout.sample_interval)
      : of_voltage ? readout::peak_magnitude(signals.sampled_circuit->column("voltage").values)
                   : value_of(signals.metrics, "peak_sampled_current_difference");
  const SampleNoise noise = sample_noise(input, peak, ions.time.back() - ions.time.front());
  for (const auto& found :
       {precursor_metrics(input, mechanics, signals.resolved, current_noise(input, noise)),
        noise_metrics(noise, peak, of_voltage ? "V" : "A")}) {
    signals.metrics.insert(signals.metrics.end(), found.begin(), found.end());
  }
}

} // namespace ionskin::study
