// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/electrochemistry/small_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace ionskin::verification {
namespace {

using Complex = std::complex<double>;

/// Permittivity of the membrane itself, and capacitance per area of platinum with many times the
/// area of its face.
constexpr double bulk = 1.8e-10, interface = 30.0; // [F/m], [F/m2]

Case cell(double permittivity, double capacitance) {
  Case input = model_case();
  input.electrochemistry.permittivity = permittivity;
  input.electrochemistry.interface_capacitance = capacitance;
  return input;
}

/// Impedance of the blocking cell, docs/model.md (73), or (33) without a capacitance of its
/// interfaces, in the limit of thin layers.
Complex blocking_impedance(const Case& input, double frequency) {
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const Complex s(0.0, 2.0 * std::numbers::pi * frequency), p = s * scales.relaxation_time;
  const double given = input.electrochemistry.interface_capacitance,
               layer =
                   given > 0 ? given : input.electrochemistry.permittivity / scales.debye_length;
  return input.skin.core_thickness() / scales.conductivity / (1.0 + p) +
         2.0 / (s * layer * std::pow(1.0 + p, 1.5));
}

void add_spectrum_rows(double capacitance, const std::string& name, std::vector<Row>& rows) {
  const Case input = cell(bulk, capacitance);
  const electrochemistry::SmallSignalCell found(input);
  double real = 0.0, imaginary = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const double frequency = 1e-4 * std::pow(10.0, 0.2 * i);
    const Complex expected = blocking_impedance(input, frequency),
                  value = found.area_impedance(frequency);
    real = std::max(real, std::abs(value.real() / expected.real() - 1.0));
    imaginary = std::max(imaginary, std::abs(value.imag() / expected.imag() - 1.0));
  }
  rows.push_back(
      at_most("E12", fmt::format("Re Z, 0.1 mHz to 1 MHz, {}, relative", name), real, 1e-3));
  rows.push_back(
      at_most("E12", fmt::format("Im Z, 0.1 mHz to 1 MHz, {}, relative", name), imaginary, 1e-3));
}

/// Adds rows on the cell charged by a voltage that rises to a thousandth of the thermal voltage.
void add_charging_rows(double permittivity, double capacitance, const std::string& name,
                       const Options& options, std::vector<Row>& rows) {
  constexpr double amplitude = 2.5e-5;
  const Case input = cell(permittivity, capacitance);
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const double time = scales.slow_time, rise = 0.05 * time;
  const std::array instants{0.1 * time, 0.5 * time, time, 3.0 * time};
  std::vector<double> samples{0.0};
  samples.insert(samples.end(), instants.begin(), instants.end());
  Case run = input;
  run.coupling.law = "column-neutral";
  run.numerics.time_tolerance = 1e-5;
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.potentials.top = [=](double at) { return -amplitude * std::expm1(-at / rise); };
  base::Timers timers;
  const auto solution = electrochemistry::solve_ion_transport(
      run, linear_step_history(0.0, 0.0, samples), ion_options, timers);
  const double area = input.skin.length * input.skin.width;
  const double layers = scales.area_ratio * permittivity / (2.0 * scales.debye_length),
               geometric = permittivity / input.skin.core_thickness(),
               core = input.skin.core_thickness() / scales.conductivity;
  for (const double at : instants) {
    // Core and layers in series beside the geometric capacitance.
    const double expected = inverse_laplace(
        [=](Complex s) {
          const Complex source = amplitude * (1.0 / s - 1.0 / (s + 1.0 / rise));
          return area * source *
                 (1.0 / (s * (core / (1.0 + s * core * geometric) + 1.0 / (s * layers))));
        },
        at);
    rows.push_back(compare("E12",
                           fmt::format("charge at {:.1f} charging times, {} [C]", at / time, name),
                           charge_difference(solution, row_at(solution, at)), expected,
                           2e-3 * area * layers * amplitude));
  }
}

} // namespace

std::vector<Row> interface_rows(const Options& options) {
  std::vector<Row> rows;
  add_spectrum_rows(0.0, "1.8e-10 F/m alone", rows);
  add_spectrum_rows(interface, "1.8e-10 F/m and 30 F/m2", rows);
  add_charging_rows(1e-8, 0.0, "1e-8 F/m alone", options, rows);
  add_charging_rows(1e-8, interface, "1e-8 F/m and 30 F/m2", options, rows);
  add_charging_rows(bulk, interface, "1.8e-10 F/m and 30 F/m2", options, rows);
  return rows;
}

} // namespace ionskin::verification
