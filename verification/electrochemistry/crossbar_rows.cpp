// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/linear_strip.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/case/document/taxel_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace ionskin::verification {
namespace {

using Complex = LinearCell::Complex;
using electrochemistry::IonSolution;

constexpr std::array crossbar_instants{1e-3, 0.01, 0.1, 1.0, 4.0};

/// Coupling coefficient, so small that the voltages of lines stay far below the thermal voltage, as
/// the linear equations require.
constexpr double small = 0.01;

/// Case of a skin of 1 by 0.5 mm under crossing lines.
Case crossed(int rows, int columns) {
  Case input = model_case();
  input.coupling.coefficient = small;
  input.skin.length = 1e-3;
  input.skin.width = 0.5e-3;
  input.readout.taxel_grid = {rows, columns, 0, TaxelWiring::crossbar};
  input.readout.taxels = taxels_of(input.readout.taxel_grid, input.skin);
  input.readout.taxel_circuit = "load";
  return input;
}

std::vector<double> sample_times() {
  std::vector<double> times{0.0};
  times.insert(times.end(), crossbar_instants.begin(), crossbar_instants.end());
  return times;
}

/// Strain history of a shear that is linear through the thickness and differs in three parts of the
/// skin along one axis.
history::CoreHistory in_parts(const Case& input, bool along_x, const std::array<double, 3>& parts,
                              double bottom, double top) {
  history::CoreHistory history = linear_step_history(bottom, top, sample_times());
  const double length = input.skin.length, width = input.skin.width;
  history.length = length;
  history.width = width;
  const double side = along_x ? length : width;
  (along_x ? history.grid.x_edges : history.grid.y_edges) = {0.0, 0.2 * side, 0.6 * side, side};
  (along_x ? history.grid.y_edges : history.grid.x_edges) = {0.0, along_x ? width : length};
  history::StrainField field;
  for (const double z : history.grid.z_nodes) {
    const double shear = bottom + (top - bottom) * z / history.grid.z_nodes.back();
    for (const double part : parts) {
      field.push_back(part * shear);
    }
  }
  const auto shared = std::make_shared<const history::StrainField>(std::move(field));
  for (auto& sample : history.shear()) {
    sample = shared;
  }
  return history;
}

double voltage(const IonSolution& solution, std::size_t line, double time) {
  return solution.lines[line].voltage[row_at(solution, time)];
}

/// Adds rows on two columns in series with loads, one grounded row and one open row, under uniform
/// shear: a bridge of conductances between four lines, of which those between lines of one face are
/// sums of waves.
void add_bridge_rows(const Options& options, std::vector<Row>& rows) {
  Case input = crossed(2, 2);
  const double area = input.skin.length * input.skin.width;
  const double load = LinearCell(input).resistance() / (0.5 * area);
  input.readout.parameters = {{"load_resistance", load}};
  input.readout.scan = {1e3, false}; // the first row for the whole run
  const history::CoreHistory history =
      in_parts(input, true, {1, 1, 1}, -step_amplitude, step_amplitude);
  const IonSolution solution = run_model(input, history, options);
  const LinearCell cell(input);
  const StripWaves across(input, input.skin.width, solution.grid.y_edges.size() - 1);
  const auto voltages = [&](Complex s) {
    const Complex whole = area / (s * cell.impedance(s)),
                  charge = 0.5 * small * area * cell.short_charge(s);
    const Complex columns = 0.5 * whole + 1.0 / (s * load), crossing = -0.25 * whole,
                  row = 0.25 * whole + area * across.odd_waves(s);
    // columns u + crossing w = -charge,  2 crossing u + row w = charge
    const Complex determinant = columns * row - 2.0 * crossing * crossing;
    return std::array<Complex, 2>{(-charge * row - crossing * charge) / determinant,
                                  (columns * charge + 2.0 * crossing * charge) / determinant};
  };
  const auto expected = [&](std::size_t line, double time) {
    return inverse_laplace([&](Complex s) { return voltages(s)[line]; }, time);
  };
  const double scale = std::abs(expected(0, 1e-3));
  for (const double time : crossbar_instants) {
    rows.push_back(compare("E14", fmt::format("voltage of a loaded column at t = {} s [V]", time),
                           voltage(solution, 0, time), expected(0, time), 2e-3 * scale));
    rows.push_back(compare("E14", fmt::format("voltage of the open row at t = {} s [V]", time),
                           voltage(solution, 3, time), expected(1, time), 2e-3 * scale));
  }
}

/// Case of the baseline's touch on two rows and three columns.
Case touched(TaxelWiring wiring) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.readout.taxel_grid = {2, 3, 0, wiring};
  input.readout.taxels = taxels_of(input.readout.taxel_grid, input.skin);
  return input;
}

void add_crossbar_limit_rows(const Options& options, std::vector<Row>& rows) {
  const history::CoreHistory touch = sliding_contact_history(1);
  const IonSolution one = run_model(touched(TaxelWiring::single), touch, options),
                    grounded = run_model(touched(TaxelWiring::crossbar), touch, options);
  double difference = 0.0;
  for (std::size_t row = 0; row < one.time.size(); ++row) {
    std::array<double, 5> of_lines{};
    for (std::size_t i = 0; i < 6; ++i) {
      of_lines[i % 3] += one.top_segments[i].charge[row];
      of_lines[3 + i / 3] += one.top_segments[i].bottom_charge[row];
    }
    for (std::size_t line = 0; line < 5; ++line) {
      difference =
          std::max(difference, std::abs(grounded.lines[line].charge[row] - of_lines[line]));
    }
  }
  rows.push_back(at_most("E14", "charge of grounded lines against one electrode, relative",
                         difference / base::largest_magnitude(one.charge_top), 1e-10));

  Case scanned = touched(TaxelWiring::crossbar);
  scanned.readout.taxel_circuit = "load";
  scanned.readout.parameters = {{"load_resistance", 300.0}};
  scanned.readout.scan = {0.1, false};
  const IonSolution cut = run_model(scanned, touch, options);
  double missing = 0.0, scale = 0.0;
  for (std::size_t row = 0; row < cut.time.size(); ++row) {
    double sum = 0.0;
    for (const auto& line : cut.lines) {
      sum += line.passed[row];
      scale = std::max(scale, std::abs(line.passed[row]));
    }
    missing = std::max(missing, std::abs(sum));
  }
  rows.push_back(at_most("E14", "charge that five scanned lines passed in sum, relative",
                         missing / scale, 1e-12));
}

/// Adds the row on exchanged faces: columns on top in series with loads over grounded rows, against
/// the same skin upside down and turned by a right angle, with rows below in series with loads
/// under grounded columns.
void add_swap_row(const Options& options, std::vector<Row>& rows) {
  constexpr std::array parts{1.0, 0.2, -0.5};
  Case upright = crossed(2, 3), turned = crossed(3, 2);
  for (Case* input : {&upright, &turned}) {
    input->skin.length = input->skin.width = 7.35e-3; // has as many columns along x as along y
    input->numerics.preset = Preset::coarse;
    input->readout.taxels = taxels_of(input->readout.taxel_grid, input->skin);
  }
  upright.readout.parameters = turned.readout.parameters = {
      {"load_resistance",
       LinearCell(upright).resistance() / (0.5 * upright.skin.length * upright.skin.width)}};
  turned.readout.taxel_circuit = "short";
  turned.readout.row_circuit = "load";
  const IonSolution one = run_model(
                        upright,
                        in_parts(upright, true, parts, 0.2 * step_amplitude, step_amplitude),
                        options),
                    other = run_model(
                        turned,
                        in_parts(turned, false, parts, step_amplitude, 0.2 * step_amplitude),
                        options);
  double difference = 0.0, scale = 0.0;
  for (const double time : crossbar_instants) {
    for (std::size_t line = 0; line < 3; ++line) {
      const double above = voltage(one, line, time), below = voltage(other, 2 + line, time);
      difference = std::max(difference, std::abs(above - below));
      scale = std::max(scale, std::abs(above));
    }
  }
  rows.push_back(at_most("E14", "voltage of columns against rows of the core upside down, relative",
                         difference / scale, 1e-5));
}

/// Adds the row on reciprocity: local shear below the first of three columns gives the middle
/// column the voltage that the same shear below the middle column gives the first; the open row
/// between them takes part.
void add_reciprocity_row(const Options& options, std::vector<Row>& rows) {
  Case input = crossed(2, 3);
  input.readout.parameters = {
      {"load_resistance",
       LinearCell(input).resistance() / (0.5 * input.skin.length * input.skin.width)}};
  input.readout.scan = {1e3, false};
  input.numerics.time_tolerance = 2e-6;
  const auto below = [&](std::size_t column) {
    history::CoreHistory history =
        in_parts(input, true, {column == 0 ? 1.0 : 0.0, column == 1 ? 1.0 : 0.0, 0.0},
                 -step_amplitude, step_amplitude);
    const double third = input.skin.length / 3.0;
    history.grid.x_edges = {0.0, third, 2.0 * third, input.skin.length};
    return run_model(input, history, options);
  };
  const IonSolution first = below(0), middle = below(1);
  double difference = 0.0, scale = 0.0;
  for (const double time : crossbar_instants) {
    const double of_middle = voltage(first, 1, time), of_first = voltage(middle, 0, time);
    difference = std::max(difference, std::abs(of_middle - of_first));
    scale = std::max(scale, std::abs(of_middle));
  }
  rows.push_back(at_most("E14", "voltage of a column by shear below the next, both ways, relative",
                         difference / scale, 1e-5));
}

} // namespace

std::vector<Row> crossbar_rows(const Options& options) {
  std::vector<Row> rows;
  add_bridge_rows(options, rows);
  add_crossbar_limit_rows(options, rows);
  add_swap_row(options, rows);
  add_reciprocity_row(options, rows);
  return rows;
}

} // namespace ionskin::verification
