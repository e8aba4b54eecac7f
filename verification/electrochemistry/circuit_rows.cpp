// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/electrochemistry/derived_scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace ionskin::verification {
namespace {

using Complex = std::complex<double>;
using electrochemistry::DerivedScales;
using electrochemistry::IonSolution;

constexpr double amplitude = 0.0015;
constexpr std::array instants{1e-3, 0.01, 0.1, 1.0, 4.0};

/// The linear cell of E3 and E4 in the Laplace domain, per area.
class LinearCell {
public:
  explicit LinearCell(const Case& input)
      : scales_(
            electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())),
        permittivity_(input.electrochemistry.permittivity) {}

  /// Charge of the step of E3 behind a load [C s/m2]: the cell drives it with its short-circuit
  /// current through its own impedance, Q = Q_short Z/(Z + R).
  /// @param load R A [ohm m2]
  Complex charge(Complex s, double load) const {
    return short_charge(s) * impedance(s) / (impedance(s) + load);
  }
  /// Voltage of the open cell [V s/m2].
  Complex open_voltage(Complex s) const { return -s * short_charge(s) * impedance(s); }
  double resistance() const {
    return 2.0 * scales_.half_thickness * scales_.debye_length / scales_.conductivity;
  }

private:
  struct Point {
    Complex p, q, tanh;
  };
  Point at(Complex s) const {
    const Complex p = s * scales_.relaxation_time, q = std::sqrt(1.0 + p);
    const Complex decay = std::exp(-2.0 * q * scales_.half_thickness);
    return {p, q, (1.0 - decay) / (1.0 + decay)};
  }
  Complex impedance(Complex s) const {
    const auto [p, q, tanh] = at(s);
    return 2.0 * scales_.debye_length * scales_.relaxation_time / permittivity_ *
           (tanh + p * q * scales_.half_thickness) / (p * q * q * q);
  }
  Complex short_charge(Complex s) const {
    const auto [p, q, tanh] = at(s);
    const double a = scales_.half_thickness;
    return scales_.charge_density * amplitude / (a * s) *
           (a / q - tanh / (q * q) + p * q * a * a * a / 3.0) / (tanh + p * q * a);
  }

  DerivedScales scales_;
  double permittivity_;
};

/// Value at `time` of a function given by its Laplace transform, by the fixed Talbot method (Abate
/// and Valko 2004, doi 10.1002/nme.995); the singularities lie on the negative real axis.
template <class Transform> double inverse_laplace(const Transform& transform, double time) {
  constexpr int points = 20;
  const double scale = 2.0 * points / (5.0 * time);
  double sum = 0.5 * std::exp(scale * time) * transform(Complex(scale)).real();
  for (int k = 1; k < points; ++k) {
    const double angle = k * std::numbers::pi / points, cotangent = 1.0 / std::tan(angle);
    const Complex s = scale * angle * Complex(cotangent, 1.0);
    const Complex slope(1.0, angle + (angle * cotangent - 1.0) * cotangent);
    sum += (std::exp(s * time) * transform(s) * slope).real();
  }
  return sum * scale / points;
}

Case circuit_case(ReadoutCircuit circuit, double load_resistance = 1.0) {
  Case input = model_case();
  input.coupling.coefficient = 1.0;
  input.readout.circuit = circuit;
  input.readout.load_resistance = load_resistance;
  return input;
}

IonSolution run_step(const Case& input, const Options& options) {
  std::vector<double> times{0.0};
  times.insert(times.end(), instants.begin(), instants.end());
  return run_model(input, linear_step_history(-amplitude, amplitude, times), options);
}

double largest_charge(const IonSolution& solution) {
  double largest = 0.0;
  for (std::size_t row = 0; row < solution.time.size(); ++row) {
    largest = std::max(largest, std::abs(charge_difference(solution, row)));
  }
  return largest;
}

void add_load_rows(const LinearCell& cell, const Options& options, std::vector<Row>& rows) {
  // A load equal to the cell's own resistance.
  const double load = cell.resistance();
  const IonSolution solution =
      run_step(circuit_case(ReadoutCircuit::load, load / electrode_area), options);
  const double scale = largest_charge(solution) / electrode_area;
  for (const double time : instants) {
    const double expected = inverse_laplace([&](Complex s) { return cell.charge(s, load); }, time);
    rows.push_back(compare("E4", fmt::format("charge behind R = h/sigma at t = {} s [C/m2]", time),
                           charge_difference(solution, row_at(solution, time)) / electrode_area,
                           expected, 2e-3 * scale));
  }
}

void add_open_rows(const LinearCell& cell, const Options& options, std::vector<Row>& rows) {
  const IonSolution solution = run_step(circuit_case(ReadoutCircuit::open), options);
  const auto expected = [&](double time) {
    return inverse_laplace([&](Complex s) { return cell.open_voltage(s); }, time);
  };
  for (const double time : {1e-3, 0.01, 0.1}) {
    rows.push_back(compare("E4", fmt::format("open-circuit voltage at t = {} s [V]", time),
                           solution.voltage[row_at(solution, time)], expected(time),
                           5e-3 * std::abs(expected(1e-3))));
  }
  rows.push_back(at_most("E4", "charge through the open circuit, over that at one electrode",
                         largest_charge(solution) /
                             (charge_density * electrode_area * amplitude * 136.244 / 3.0),
                         1e-12));
}

/// Largest difference of a quantity at the instants of two runs, over its largest magnitude there.
template <class Quantity>
double largest_difference(const IonSolution& a, const IonSolution& b, const Quantity& quantity) {
  double difference = 0.0, scale = 0.0;
  for (const double time : instants) {
    const double at_a = quantity(a, row_at(a, time)), at_b = quantity(b, row_at(b, time));
    difference = std::max(difference, std::abs(at_a - at_b));
    scale = std::max(scale, std::abs(at_b));
  }
  return difference / scale;
}

void add_limit_rows(const Options& options, std::vector<Row>& rows) {
  const auto loaded = [&](double load) {
    return run_step(circuit_case(ReadoutCircuit::load, load), options);
  };
  rows.push_back(
      at_most("E4", "charge behind 1 mOhm against the short circuit",
              largest_difference(loaded(1e-3),
                                 run_step(circuit_case(ReadoutCircuit::short_circuit), options),
                                 charge_difference),
              1e-3));
  rows.push_back(
      at_most("E4", "voltage at 1 GOhm against the open circuit",
              largest_difference(loaded(1e9), run_step(circuit_case(ReadoutCircuit::open), options),
                                 [](const IonSolution& solution, std::size_t row) {
                                   return solution.voltage[row];
                                 }),
              1e-3));
}

} // namespace

std::vector<Row> circuit_rows(const Options& options) {
  const LinearCell cell(circuit_case(ReadoutCircuit::open));
  std::vector<Row> rows;
  add_load_rows(cell, options, rows);
  add_open_rows(cell, options, rows);
  add_limit_rows(options, rows);
  return rows;
}

} // namespace ionskin::verification
