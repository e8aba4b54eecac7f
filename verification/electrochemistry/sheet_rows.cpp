// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/sheet_impedance.hpp"
#include "ionskin/electrochemistry/small_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::verification {
namespace {

using Complex = LinearCell::Complex;
using electrochemistry::IonSolution;

constexpr double squares = 4.0;                 // [ohm], of both metals together
constexpr double amplitude = 1e-4, rise = 0.05; // of the voltage at the leads [V], [s]
constexpr std::array sheet_instants{0.1, 0.3, 1.0, 3.0};

/// Case of a strip, many core thicknesses long, whose electrodes have a sheet resistance.
Case strip(ElectrodeContact contact) {
  Case input = model_case();
  input.skin.width = 0.2e-3;
  input.skin.layers.front().sheet_resistance = 0.25 * squares;
  input.skin.layers.back().sheet_resistance = 0.75 * squares;
  input.readout.contact = contact;
  input.numerics.preset = Preset::coarse;
  input.numerics.time_tolerance = 1e-5;
  return input;
}

/// Instants up to `end` at which charges are compared.
std::vector<double> instants_until(double end) {
  std::vector<double> times(sheet_instants.begin(), sheet_instants.end());
  std::erase_if(times, [end](double time) { return time > end; });
  return times;
}

history::CoreHistory at_rest(const Case& input, std::vector<double> times) {
  times.insert(times.begin(), 0.0);
  history::CoreHistory history = linear_step_history(0.0, 0.0, std::move(times));
  history.width = input.skin.width;
  history.grid.y_edges = {0.0, input.skin.width};
  return history;
}

/// Solves the cell with its leads at the voltage amplitude (1 - exp(-t/rise)).
IonSolution charge_by_leads(const Case& input, const Options& options,
                            double end = sheet_instants.back()) {
  const std::vector<double> times = instants_until(end);
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  ion_options.potentials.top = [](double time) { return -amplitude * std::expm1(-time / rise); };
  ion_options.snapshot_times = times;
  base::Timers timers;
  return electrochemistry::solve_ion_transport(input, at_rest(input, times), ion_options, timers);
}

/// Closed-form solution in the Laplace domain of a line of resistors along the metal and cells
/// across it, docs/model.md (68).
class Line {
public:
  explicit Line(const Case& input)
      : cell_(input), width_(input.skin.width),
        length_(input.readout.contact == ElectrodeContact::both_ends ? 0.5 * input.skin.length
                                                                     : input.skin.length),
        lines_(input.skin.length / length_) {}

  /// Voltage across the cell at a distance from the lead, over the voltage of the leads.
  Complex voltage(Complex s, double distance) const {
    const Complex wave = std::sqrt(squares / cell_.impedance(s));
    return std::cosh(wave * (length_ - distance)) / std::cosh(wave * length_);
  }
  Complex admittance(Complex s) const {
    const Complex wave = std::sqrt(squares / cell_.impedance(s));
    return lines_ * width_ * wave / squares * std::tanh(wave * length_);
  }
  /// Laplace transform of the voltage of the leads.
  static Complex source(Complex s) { return amplitude * (1.0 / s - 1.0 / (s + 1.0 / rise)); }

  double charge(double time) const {
    return inverse_laplace([&](Complex s) { return source(s) * admittance(s) / s; }, time);
  }
  double voltage(double time, double distance) const {
    return inverse_laplace([&](Complex s) { return source(s) * voltage(s, distance); }, time);
  }

private:
  LinearCell cell_;
  double width_, length_, lines_;
};

/// Voltage across the cell at the far end of a snapshot's first row of columns.
double far_voltage(const IonSolution& solution, std::size_t snapshot, std::size_t column) {
  const auto& potential = solution.snapshots[snapshot].potential;
  const std::size_t columns =
      (solution.grid.x_edges.size() - 1) * (solution.grid.y_edges.size() - 1);
  return potential[potential.size() - columns + column] - potential[column];
}

void add_line_rows(ElectrodeContact contact, const std::string& name, const Options& options,
                   std::vector<Row>& rows) {
  const Case input = strip(contact);
  const IonSolution solution = charge_by_leads(input, options);
  const Line line(input);
  const std::size_t count = solution.grid.x_edges.size() - 1;
  const std::size_t column = contact == ElectrodeContact::both_ends ? count / 2 : count - 1;
  const double distance = 0.5 * (solution.grid.x_edges[column] + solution.grid.x_edges[column + 1]);
  for (std::size_t i = 0; i < sheet_instants.size(); ++i) {
    const double time = sheet_instants[i];
    rows.push_back(compare("E11", fmt::format("charge by {} at t = {} s [C]", name, time),
                           charge_difference(solution, row_at(solution, time)), line.charge(time),
                           1e-3 * line.charge(sheet_instants.back())));
    rows.push_back(
        compare("E11", fmt::format("voltage farthest from {} at t = {} s [V]", name, time),
                far_voltage(solution, i, column), line.voltage(time, distance), 1e-3 * amplitude));
  }
}

void add_sheet_order_row(const Options& options, std::vector<Row>& rows) {
  constexpr double instant = 0.1;
  std::array<double, 3> charge{};
  for (std::size_t i = 0; i < charge.size(); ++i) {
    Case input = strip(ElectrodeContact::one_end);
    input.numerics.mesh_refinement = 0.8 * std::pow(2.0, static_cast<double>(i));
    input.numerics.time_tolerance = 3e-6;
    const IonSolution solution = charge_by_leads(input, options, instant);
    charge[i] =
        charge_difference(solution, row_at(solution, instant)) - Line(input).charge(instant);
    rows.push_back(compare("E11",
                           fmt::format("charge at t = {} s, {} columns [C]", instant,
                                       solution.grid.x_edges.size() - 1),
                           charge[i] + Line(input).charge(instant), Line(input).charge(instant),
                           5e-3 * Line(input).charge(instant)));
  }
  rows.push_back(at_least("E11", "order of the charge by the columns",
                          std::log2((charge[0] - charge[1]) / (charge[1] - charge[2])), 1.8));
}

/// Adds rows on a lead at a corner. The end of a lead makes the current density singular, and
/// columns resolve it in proportion to their width.
void add_corner_rows(const Options& options, std::vector<Row>& rows) {
  Case input = strip(ElectrodeContact::corner);
  input.skin.width = 2.4e-3;
  input.numerics.time_tolerance = 1e-4; // a hundredth of what the columns leave
  const IonSolution solution = charge_by_leads(input, options);
  const electrochemistry::SheetImpedance metal(input);
  const LinearCell cell(input);
  const double area = input.skin.length * input.skin.width;
  const auto expected = [&](double time) {
    return inverse_laplace(
        [&](Complex s) {
          return Line::source(s) * area / (s * metal.area_impedance(cell.impedance(s)));
        },
        time);
  };
  const double scale = expected(sheet_instants.back());
  for (const double time : sheet_instants) {
    rows.push_back(compare("E11", fmt::format("charge by leads at a corner at t = {} s [C]", time),
                           charge_difference(solution, row_at(solution, time)), expected(time),
                           1e-2 * scale));
  }
  const double instant = sheet_instants[1];
  const auto error = [&](const IonSolution& found) {
    return std::abs(charge_difference(found, row_at(found, instant)) - expected(instant));
  };
  input.numerics.mesh_refinement = 2.0;
  rows.push_back(
      at_least("E11", "order of the charge by leads at a corner by the columns",
               std::log2(error(solution) / error(charge_by_leads(input, options, instant))), 0.8));
}

/// Impedance of a ladder of many resistors and cells, summed from the far end on.
Complex ladder(Complex cell, double length, double width, int count) {
  const double step = length / count;
  Complex admittance = 0.0;
  for (int i = 0; i < count; ++i) {
    // Half of the metal on either side of each cell.
    const double half = 0.5 * squares * step / width;
    admittance = step * width / cell + (i == 0 ? 0.0 : admittance / (1.0 + half * admittance));
    admittance = admittance / (1.0 + half * admittance);
  }
  return 1.0 / admittance;
}

void add_impedance_rows(std::vector<Row>& rows) {
  for (const ElectrodeContact contact : {ElectrodeContact::one_end, ElectrodeContact::both_ends}) {
    const Case input = strip(contact);
    const LinearCell cell(input);
    const electrochemistry::SmallSignalCell found(input);
    const bool both = contact == ElectrodeContact::both_ends;
    const double reach = (both ? 0.5 : 1.0) * input.skin.length;
    double worst = 0.0;
    for (int i = 0; i <= 30; ++i) {
      const double frequency = 1e-3 * std::pow(10.0, 0.2 * i);
      const Complex s(0.0, 2.0 * std::numbers::pi * frequency);
      const Complex expected = (both ? 0.5 : 1.0) *
                               ladder(cell.impedance(s), reach, input.skin.width, 20000) *
                               input.skin.length * input.skin.width;
      worst = std::max(worst, std::abs(found.area_impedance(frequency) / expected - 1.0));
    }
    rows.push_back(at_most("E11",
                           fmt::format("impedance, 1 mHz to 1 kHz, leads at {}, against a ladder",
                                       both ? "both ends" : "one end"),
                           worst, 1e-3));
  }
}

/// Case of the slider's touch.
Case touched(double resistance, const char* circuit, const char* law) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 0.5; // what must hold holds on any mesh
  input.coupling.law = law;
  input.readout.circuit = circuit;
  input.readout.parameters = {{"load_resistance", 300.0}};
  input.skin.layers.front().sheet_resistance = resistance;
  input.skin.layers.back().sheet_resistance = resistance;
  return input;
}

void add_sheet_limit_rows(const Options& options, std::vector<Row>& rows) {
  const history::CoreHistory touch = sliding_contact_history(1);
  for (const char* circuit : {"short", "load"}) {
    const IonSolution none = run_model(touched(0.0, circuit, "fixed-charge"), touch, options),
                      little = run_model(touched(1e-5, circuit, "fixed-charge"), touch, options);
    double difference = 0.0, scale = 0.0;
    for (const double time : {2.5, 4.0}) {
      const double charge = charge_difference(none, row_at(none, time));
      difference =
          std::max(difference, std::abs(charge_difference(little, row_at(little, time)) - charge));
      scale = std::max(scale, std::abs(charge));
    }
    rows.push_back(at_most(
        "E11", fmt::format("charge at 10 uOhm a square against none, {}, relative", circuit),
        difference / scale, 1e-3));
  }
}

void add_sheet_conservation_rows(const Options& options, std::vector<Row>& rows) {
  const IonSolution open = run_model(touched(1.0, "open", "column-neutral"),
                                     sliding_contact_history(1), options),
                    shorted = run_model(touched(1.0, "short", "column-neutral"),
                                        sliding_contact_history(1), options);
  double walls = 0.0;
  for (std::size_t row = 0; row < shorted.time.size(); ++row) {
    walls = std::max(walls, std::abs(shorted.charge_top[row] + shorted.charge_bottom[row]));
  }
  const double scale = base::largest_magnitude(shorted.charge_top);
  rows.push_back(at_most("E11", "charge of both electrodes at 1 ohm a square, relative",
                         walls / scale, 1e-10));
  rows.push_back(at_most("E11", "charge that passes open leads at 1 ohm a square, relative",
                         base::largest_magnitude(open.charge_top) / scale, 1e-10));
}

} // namespace

std::vector<Row> sheet_rows(const Options& options) {
  std::vector<Row> rows;
  add_line_rows(ElectrodeContact::one_end, "a lead at one end", options, rows);
  add_line_rows(ElectrodeContact::both_ends, "leads at both ends", options, rows);
  add_sheet_order_row(options, rows);
  add_corner_rows(options, rows);
  add_impedance_rows(rows);
  add_sheet_limit_rows(options, rows);
  add_sheet_conservation_rows(options, rows);
  return rows;
}

} // namespace ionskin::verification
