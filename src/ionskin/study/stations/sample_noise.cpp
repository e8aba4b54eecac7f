// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/stations/sample_noise.hpp"

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

/// Of an instrument that averages over its interval, beside that average.
constexpr double bandwidth_over_rate = 10;

/// Of what is beside the cell between the electrodes.
Complex admittance(const circuits::Circuit& circuit, double frequency) {
  return circuit.admittance
             ? Complex(1 / circuit.admittance->resistance,
                       2 * std::numbers::pi * frequency * circuit.admittance->capacitance)
             : Complex(0);
}

} // namespace

double SampleNoise::total() const {
  return std::sqrt(thermal * thermal + amplifier * amplifier + quantisation * quantisation);
}

SampleNoise sample_noise(const Case& input, double peak, double record) {
  const circuits::Circuit circuit =
      circuits::circuit(input.readout.circuit, input.readout.parameters);
  const circuits::Instrument& instrument = circuits::instrument(input.readout.instrument);
  const double interval = input.readout.sample_interval;
  const circuits::Averaging averaging{interval, bandwidth_over_rate / interval,
                                      std::max(record, interval)};
  const electrochemistry::SmallSignalCell cell(input);
  const double area = input.skin.length * input.skin.width;
  const double thermal_power = 4 * constants::boltzmann * input.electrochemistry.temperature;
  const auto voltage = [&](double frequency) {
    return 1.0 / (area / cell.area_impedance(frequency) + admittance(circuit, frequency));
  };
  const auto current = [&](double frequency) { return area / cell.area_impedance(frequency); };
  const auto mean = [&](const auto& density) { return noise_of_mean(density, averaging); };
  SampleNoise noise;
  if (circuit.admittance) {
    noise.thermal =
        mean([&](double frequency) { return thermal_power * voltage(frequency).real(); });
    noise.amplifier = mean([&](double frequency) {
      return std::pow(instrument.voltage_noise, 2) +
             std::norm(instrument.current_noise * voltage(frequency));
    });
  } else {
    noise.thermal =
        mean([&](double frequency) { return thermal_power * current(frequency).real(); });
    noise.amplifier =
        circuit.reading_noise ? circuit.reading_noise(interval) : mean([&](double frequency) {
          return std::pow(instrument.current_noise, 2) +
                 std::norm(instrument.voltage_noise * current(frequency));
        });
  }
  noise.quantisation = circuits::quantisation_noise(instrument, peak);
  return noise;
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
