// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace ionskin::verification {
namespace {

using Complex = LinearCell::Complex;
using electrochemistry::IonSolution;

constexpr std::array compared_instants{1e-3, 0.01, 0.1, 1.0, 4.0};

Case circuit_case(const char* circuit, double resistance = 1.0, double capacitance = 0.0) {
  Case input = model_case();
  input.coupling.coefficient = 1.0;
  input.readout.circuit = circuit;
  input.readout.parameters = {{"load_resistance", resistance}, {"load_capacitance", capacitance}};
  return input;
}

IonSolution run_circuit(const Case& input, const Options& options) {
  std::vector<double> times{0.0};
  times.insert(times.end(), compared_instants.begin(), compared_instants.end());
  return run_model(input, linear_step_history(-step_amplitude, step_amplitude, times), options);
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
  const IonSolution solution = run_circuit(circuit_case("load", load / electrode_area), options);
  const double scale = largest_charge(solution) / electrode_area;
  for (const double time : compared_instants) {
    const double expected = inverse_laplace([&](Complex s) { return cell.charge(s, load); }, time);
    rows.push_back(compare("E4", fmt::format("charge behind R = h/sigma at t = {} s [C/m2]", time),
                           charge_difference(solution, row_at(solution, time)) / electrode_area,
                           expected, 2e-3 * scale));
  }
}

void add_parallel_rows(const LinearCell& cell, const Options& options, std::vector<Row>& rows) {
  // The cell's own resistance beside a capacitor that it charges in a tenth of a second.
  const double resistance = cell.resistance(), capacitance = 0.1 / resistance;
  const IonSolution solution = run_circuit(
      circuit_case("parallel-rc", resistance / electrode_area, capacitance * electrode_area),
      options);
  const auto load = [&](Complex s) { return resistance / (1.0 + s * resistance * capacitance); };
  const double scale = largest_charge(solution) / electrode_area;
  const double largest_voltage =
      std::ranges::max(solution.voltage, {}, [](double voltage) { return std::abs(voltage); });
  for (const double time : compared_instants) {
    const std::size_t row = row_at(solution, time);
    const auto charge = [&](Complex s) { return cell.charge(s, load(s)); };
    rows.push_back(
        compare("E4", fmt::format("charge behind R and C in parallel at t = {} s [C/m2]", time),
                charge_difference(solution, row) / electrode_area, inverse_laplace(charge, time),
                2e-3 * scale));
    rows.push_back(
        compare("E4", fmt::format("voltage over R and C in parallel at t = {} s [V]", time),
                solution.voltage[row],
                inverse_laplace([&](Complex s) { return -s * charge(s) * load(s); }, time),
                5e-3 * std::abs(largest_voltage)));
  }
}

void add_open_rows(const LinearCell& cell, const Options& options, std::vector<Row>& rows) {
  const IonSolution solution = run_circuit(circuit_case("open"), options);
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
                             (charge_density * electrode_area * step_amplitude * 136.244 / 3.0),
                         1e-12));
}

/// Largest difference of a quantity between two runs at the compared instants, over the largest
/// magnitude of the quantity there.
template <class Quantity>
double largest_difference(const IonSolution& a, const IonSolution& b, const Quantity& quantity) {
  double difference = 0.0, scale = 0.0;
  for (const double time : compared_instants) {
    const double at_a = quantity(a, row_at(a, time)), at_b = quantity(b, row_at(b, time));
    difference = std::max(difference, std::abs(at_a - at_b));
    scale = std::max(scale, std::abs(at_b));
  }
  return difference / scale;
}

void add_limit_rows(const Options& options, std::vector<Row>& rows) {
  const auto loaded = [&](double load) { return run_circuit(circuit_case("load", load), options); };
  rows.push_back(
      at_most("E4", "charge behind 1 mOhm against the short circuit",
              largest_difference(loaded(1e-3), run_circuit(circuit_case("short"), options),
                                 charge_difference),
              1e-3));
  rows.push_back(at_most("E4", "voltage at 1 GOhm against the open circuit",
                         largest_difference(loaded(1e9), run_circuit(circuit_case("open"), options),
                                            [](const IonSolution& solution, std::size_t row) {
                                              return solution.voltage[row];
                                            }),
                         1e-3));
}

} // namespace

std::vector<Row> circuit_rows(const Options& options) {
  const LinearCell cell(circuit_case("open"));
  std::vector<Row> rows;
  add_load_rows(cell, options, rows);
  add_parallel_rows(cell, options, rows);
  add_open_rows(cell, options, rows);
  add_limit_rows(options, rows);
  return rows;
}

} // namespace ionskin::verification
