// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/sample_noise.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/circuits/instruments.hpp"
#include "ionskin/circuits/noise_of_mean.hpp"
#include "ionskin/electrochemistry/small_signal.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace ionskin::study {
namespace {

using Complex = std::complex<double>;

/// Bandwidth of an averaging instrument without a bandwidth of its own, over its sampling rate [1].
constexpr double bandwidth_over_rate = 10;

/// The named instrument, with the numbers that the case gives itself.
circuits::Instrument instrument_of(const Readout& readout) {
  circuits::Instrument result = circuits::instrument(readout.instrument);
  result.voltage_noise = readout.instrument_voltage_noise.value_or(result.voltage_noise);
  result.current_noise = readout.instrument_current_noise.value_or(result.current_noise);
  result.bits = readout.instrument_bits.value_or(result.bits);
  return result;
}

Complex admittance(const circuits::Admittance& beside, double frequency) {
  return {1 / beside.resistance, 2 * std::numbers::pi * frequency * beside.capacitance};
}

} // namespace

double SampleNoise::total() const {
  return std::sqrt(thermal * thermal + amplifier * amplifier + quantisation * quantisation);
}

SampleNoise sample_noise(const Case& input, double peak, double record) {
  const circuits::Circuit circuit =
      circuits::circuit(input.readout.circuit, input.readout.parameters);
  const circuits::Instrument instrument = instrument_of(input.readout);
  const double interval = input.readout.sample_interval;
  const double bandwidth =
      circuit.input_noise ? circuit.input_noise->bandwidth : bandwidth_over_rate / interval;
  // A circuit with an amplifier of its own has the current noise that its key gives. The voltage
  // noise of the instrument drives a current through the cell in either case.
  const double own_current_noise = circuit.input_noise ? circuit.input_noise->current : 0.0;
  const double current_noise = own_current_noise > 0 ? own_current_noise : instrument.current_noise;
  const electrochemistry::SmallSignalCell cell(input);
  const double area = input.skin.length * input.skin.width;
  // Transfer from one of voltage and current to the other, which is read: the admittance of the
  // cell, or the impedance of the cell and all that is beside it. Its real part gives the thermal
  // noise, its magnitude turns the amplifier's other noise into the one that is read.
  const auto transfer = [&](double frequency) {
    const Complex own = area / cell.area_impedance(frequency);
    return circuit.admittance ? 1.0 / (own + admittance(*circuit.admittance, frequency)) : own;
  };
  const double direct = circuit.admittance ? instrument.voltage_noise : current_noise,
               turned = circuit.admittance ? current_noise : instrument.voltage_noise;
  const double thermal_power = 4 * constants::boltzmann * input.electrochemistry.temperature;
  const auto mean = [&](const auto& density) {
    return circuits::noise_of_mean(density, {interval, bandwidth, std::max(record, interval)});
  };
  return {mean([&](double frequency) { return thermal_power * transfer(frequency).real(); }),
          mean([&](double frequency) {
            return direct * direct + std::norm(turned * transfer(frequency));
          }),
          circuits::quantisation_noise(instrument, peak)};
}

double current_noise(const Case& input, const SampleNoise& noise) {
  const circuits::Circuit circuit =
      circuits::circuit(input.readout.circuit, input.readout.parameters);
  if (!circuit.admittance) {
    return noise.total();
  }
  return noise.total() * (1 / circuit.admittance->resistance +
                          circuit.admittance->capacitance / input.readout.sample_interval);
}

std::vector<readout::Metric> noise_metrics(const SampleNoise& noise, double peak,
                                           const std::string& unit) {
  return {{"sample_noise_thermal", noise.thermal, unit},
          {"sample_noise_amplifier", noise.amplifier, unit},
          {"sample_noise_quantisation", noise.quantisation, unit},
          {"sample_noise", noise.total(), unit},
          {"signal_to_noise", peak / noise.total(), "1"}};
}

} // namespace ionskin::study
