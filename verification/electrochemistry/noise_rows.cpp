// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/study/metrics/sample_noise.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>
#include <vector>

namespace ionskin::verification {
namespace {

Case measured_cell(const char* circuit, double interval, laws::LawValues parameters) {
  Case input = model_case();
  input.readout.circuit = circuit;
  input.readout.parameters = std::move(parameters);
  input.readout.sample_interval = interval;
  return input;
}

double thermal_energy(const Case& input) {
  return constants::boltzmann * input.electrochemistry.temperature;
}

/// Row on a resistor: white noise of 4 k T R, averaged over an interval T behind a low pass of
/// 10/T: sigma^2 = 2 k T R / T (1 - (1 - exp(-a))/a),   a = 20 pi.
Row resistor_row() {
  constexpr double resistance = 1e-5, interval = 0.01, record = 1e6;
  const Case input = measured_cell("load", interval, {{"load_resistance", resistance}});
  constexpr double a = 20.0 * std::numbers::pi;
  const double expected =
      std::sqrt(2.0 * thermal_energy(input) * resistance / interval * (1.0 + std::expm1(-a) / a));
  return compare("E13", "noise of a resistor far below the cell's, mean over 10 ms [V]",
                 study::sample_noise(input, 0.0, record).thermal, expected, 2e-3 * expected);
}

/// Row on a cell beside a capacitor: whatever cell and resistor do in between, the voltage at an
/// instant shows k T over the capacitance for the quickest changes, which is the core as a
/// dielectric and the capacitor.
Row capacitance_row(double capacitance) {
  constexpr double resistance = 10.0, instant = 1e-7, record = 1e5;
  const Case input = measured_cell(
      "parallel-rc", instant, {{"load_resistance", resistance}, {"load_capacitance", capacitance}});
  const double geometric = input.electrochemistry.permittivity * input.skin.length *
                           input.skin.width / input.skin.core_thickness();
  const double expected = std::sqrt(thermal_energy(input) / (geometric + capacitance));
  return compare("E13",
                 fmt::format("noise of the cell at 10 ohm and {} F, an instant: root of k T/C [V]",
                             capacitance),
                 study::sample_noise(input, 0.0, record).thermal, expected, 2e-3 * expected);
}

} // namespace

std::vector<Row> noise_rows() {
  return {resistor_row(), capacitance_row(1e-4), capacitance_row(1e-3)};
}

} // namespace ionskin::verification
