// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"
#include "electrochemistry/linear_strip.hpp"
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"
#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <utility>

namespace ionskin::verification {
namespace {

using Complex = LinearCell::Complex;
using electrochemistry::IonSolution;

constexpr double strip_length = 1e-3, strip_width = 0.5e-3; // [m]

/// Coupling coefficient, so small that the voltages of an open taxel stay far below the thermal
/// voltage, as the linear equations require.
constexpr double smallness = 0.01;
constexpr std::array compared_instants{1e-3, 0.01, 0.1, 1.0, 4.0};

/// Case of a strip whose top face is cut across its middle; every taxel has its own load.
Case strip(double load_a, double load_b) {
  Case input = model_case();
  input.coupling.coefficient = smallness;
  input.skin.length = strip_length;
  input.skin.width = strip_width;
  input.readout.taxel_circuit = "load";
  input.readout.taxels = {
      {"a", {0, 0}, {strip_length / 2, strip_width}, "", {{"load_resistance", load_a}}},
      {"b", {strip_length / 2, 0}, {strip_length, strip_width}, "", {{"load_resistance", load_b}}}};
  return input;
}

IonSolution run_strip(const Case& input, const Options& options) {
  std::vector<double> times{0.0};
  times.insert(times.end(), compared_instants.begin(), compared_instants.end());
  history::CoreHistory history = linear_step_history(-step_amplitude, step_amplitude, times);
  history.length = strip_length;
  history.width = strip_width;
  history.grid.x_edges = {0.0, strip_length};
  history.grid.y_edges = {0.0, strip_width};
  return run_model(input, history, options);
}

/// Closed-form solution of two halves of a linear strip, each with its load, by waves along it,
/// docs/model.md (66).
class CutStrip {
public:
  /// @param columns of the grid whose waves are summed; 0 for waves of a continuum
  CutStrip(const Case& input, std::size_t columns)
      : cell_(input), waves_(input, strip_length, columns),
        loads_{input.readout.taxels[0].parameters.at("load_resistance"),
               input.readout.taxels[1].parameters.at("load_resistance")} {}

  /// Laplace transforms of the voltages of both halves.
  std::array<Complex, 2> voltages(Complex s) const {
    const double area = strip_length * strip_width;
    const Complex even = area / (4.0 * s * cell_.impedance(s)), odd = area * waves_.odd_waves(s);
    const Complex charge = 0.5 * smallness * area * cell_.short_charge(s);
    const Complex own_a = even + odd + 1.0 / (s * loads_[0]),
                  own_b = even + odd + 1.0 / (s * loads_[1]), mutual = even - odd;
    const Complex determinant = own_a * own_b - mutual * mutual;
    return {-charge * (own_b - mutual) / determinant, -charge * (own_a - mutual) / determinant};
  }

private:
  LinearCell cell_;
  StripWaves waves_;
  std::array<double, 2> loads_;
};

double voltage(const IonSolution& solution, std::size_t taxel, double time) {
  return solution.top_segments[taxel].voltage[row_at(solution, time)];
}

double expected(const CutStrip& strip, std::size_t taxel, double time) {
  return inverse_laplace([&](Complex s) { return strip.voltages(s)[taxel]; }, time);
}

/// Case of one taxel in series with the resistance of the core below it, and of another that is
/// practically open, whose voltage leaks along the core to the first.
Case bridged(const Case& plain) {
  const double resistance = LinearCell(plain).resistance() / (0.5 * strip_length * strip_width);
  return strip(resistance, 1e6 * resistance);
}

void add_bridge_rows(const Options& options, std::vector<Row>& rows) {
  const Case input = bridged(strip(1, 1));
  const IonSolution solution = run_strip(input, options);
  const CutStrip reference(input, solution.grid.x_edges.size() - 1);
  const double scale = std::abs(expected(reference, 1, 1e-3));
  for (const double time : compared_instants) {
    for (const std::size_t taxel : {0U, 1U}) {
      rows.push_back(compare("E10",
                             fmt::format("voltage of the {} taxel of two at t = {} s [V]",
                                         taxel == 0 ? "loaded" : "open", time),
                             voltage(solution, taxel, time), expected(reference, taxel, time),
                             2e-3 * scale));
    }
  }
}

/// Adds the row on the order by columns, at 4 s, when the double layers have carried the leak
/// further than a column is wide, so that the cut is resolved.
void add_order_row(const Options& options, std::vector<Row>& rows) {
  constexpr double instant = 4.0;
  std::vector<double> errors;
  for (const double refinement : {1.0, 2.0}) {
    Case input = bridged(strip(1, 1));
    input.numerics.mesh_refinement = refinement;
    input.numerics.time_tolerance = 1e-5;
    errors.push_back(std::abs(voltage(run_strip(input, options), 1, instant) -
                              expected(CutStrip(input, 0), 1, instant)));
  }
  rows.push_back(at_least("E10", "order of the voltage of the open taxel by the columns",
                          std::log2(errors[0] / errors[1]), 1.0));
}

/// Case of the baseline's skin, on five taxels.
Case five_taxels(const char* circuit) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.readout.taxel_circuit = circuit;
  input.readout.parameters = {{"load_resistance", 1e-3}};
  for (int i = 0; i < 5; ++i) {
    input.readout.taxels.push_back({std::string(1, static_cast<char>('a' + i)),
                                    {i * 3e-3, 0.0},
                                    {(i + 1) * 3e-3, input.skin.width},
                                    {},
                                    {}});
  }
  return input;
}

/// Adds the conservation of charge in the slider's touch on five taxels behind loads.
void add_conservation_rows(const Options& options, std::vector<Row>& rows) {
  Case input = five_taxels("load");
  input.coupling.law = "column-neutral";
  input.readout.parameters = {{"load_resistance", 300.0}};
  const IonSolution solution = run_model(input, sliding_contact_history(1), options);
  double walls = 0.0, sum = 0.0;
  for (std::size_t row = 0; row < solution.time.size(); ++row) {
    double charge = solution.charge_top[row];
    walls = std::max(walls, std::abs(charge + solution.charge_bottom[row]));
    for (const auto& taxel : solution.top_segments) {
      charge -= taxel.passed[row];
    }
    sum = std::max(sum, std::abs(charge));
  }
  const double scale = base::largest_magnitude(solution.charge_top);
  rows.push_back(at_most("E10", "charge of top and bottom of five loaded taxels, relative",
                         walls / scale, 1e-10));
  rows.push_back(at_most("E10", "charge of the top less what five loads passed, relative",
                         sum / scale, 1e-10));
}

/// Strain history of a local shear, odd through the thickness, in one lateral column at rest.
history::CoreHistory local_history(bool at_the_left, double length) {
  std::vector<double> times{0.0};
  times.insert(times.end(), compared_instants.begin(), compared_instants.end());
  history::CoreHistory history = linear_step_history(-step_amplitude, step_amplitude, times);
  history.length = length;
  history.width = strip_width;
  history.grid.x_edges = {0.0, 0.1 * length, 0.9 * length, length};
  history.grid.y_edges = {0.0, strip_width};
  history::StrainField field;
  for (const double z : history.grid.z_nodes) {
    const double shear = step_amplitude * (2.0 * z / history.grid.z_nodes.back() - 1.0);
    field.insert(field.end(), {at_the_left ? shear : 0.0, 0.0, at_the_left ? 0.0 : shear});
  }
  const auto shared = std::make_shared<const history::StrainField>(std::move(field));
  for (auto& sample : history.shear()) {
    sample = shared;
  }
  return history;
}

/// Adds the reciprocity of two taxels: the same shear at the far end of one gives the other the
/// same voltage both ways, though the taxels differ in size and load.
void add_reciprocity_row(const Options& options, std::vector<Row>& rows) {
  constexpr double length = 2e-3, cut = 0.8e-3;
  const double resistance = LinearCell(strip(1, 1)).resistance() / (0.5 * length * strip_width);
  Case input = strip(resistance, 5.0 * resistance);
  input.skin.length = length;
  input.readout.taxels[0].upper[0] = input.readout.taxels[1].lower[0] = cut;
  input.readout.taxels[1].upper[0] = length;
  input.numerics.time_tolerance = 2e-6;
  const IonSolution left = run_model(input, local_history(true, length), options),
                    right = run_model(input, local_history(false, length), options);
  double difference = 0.0, scale = 0.0;
  for (const double time : compared_instants) {
    const double of_b = voltage(left, 1, time), of_a = voltage(right, 0, time);
    difference = std::max(difference, std::abs(of_b - of_a));
    scale = std::max(scale, std::abs(of_b));
  }
  rows.push_back(at_most("E10", "voltage of a taxel by shear below the other, both ways, relative",
                         difference / scale, 2e-3));
}

void add_limit_rows(const Options& options, std::vector<Row>& rows) {
  const history::CoreHistory touch = sliding_contact_history(1);
  const IonSolution one = run_model(five_taxels("shared"), touch, options),
                    grounded = run_model(five_taxels("short"), touch, options),
                    loaded = run_model(five_taxels("load"), touch, options);
  double held = 0.0, nearly = 0.0;
  for (std::size_t taxel = 0; taxel < 5; ++taxel) {
    const auto& expected_charge = one.top_segments[taxel].charge;
    for (std::size_t row = 0; row < expected_charge.size(); ++row) {
      held =
          std::max(held, std::abs(grounded.top_segments[taxel].charge[row] - expected_charge[row]));
    }
    nearly = std::max(nearly, std::abs(loaded.top_segments[taxel].charge[row_at(loaded, 2.5)] -
                                       expected_charge[row_at(one, 2.5)]));
  }
  const double scale = base::largest_magnitude(one.charge_top);
  rows.push_back(at_most("E10", "charge of five grounded taxels against one electrode, relative",
                         held / scale, 1e-10));
  rows.push_back(at_most("E10", "charge of five taxels behind 1 mOhm against it, relative",
                         nearly / scale, 1e-3));

  std::vector<double> times{0.0};
  times.insert(times.end(), compared_instants.begin(), compared_instants.end());
  const history::CoreHistory even = linear_step_history(-step_amplitude, step_amplitude, times);
  Case cell = five_taxels("shared");
  cell.readout.circuit = "open";
  const IonSolution whole = run_model(cell, even, options),
                    open = run_model(five_taxels("open"), even, options);
  double difference = 0.0;
  for (const double time : compared_instants) {
    for (std::size_t taxel = 0; taxel < 5; ++taxel) {
      difference = std::max(
          difference, std::abs(voltage(open, taxel, time) - whole.voltage[row_at(whole, time)]));
    }
  }
  rows.push_back(at_most("E10", "voltage of five open taxels against the open cell, relative",
                         difference / base::largest_magnitude(whole.voltage), 1e-8));
}

/// Two taxels that are read in turns, each by its load while the other is open, are by and by two
/// behind twice the resistance: what they lag behind goes with the dwell.
/// A strip whose bulk relaxes within seconds (permittivity over conductivity), which a dwell must
/// not outlast: else a taxel that is read sees the core's resistance whole, not half of the time.
Case dilute_strip(double load_a, double load_b) {
  Case input = strip(load_a, load_b);
  input.electrochemistry.fixed_charge_concentration = 1;
  return input;
}

void add_scan_rows(const Options& options, std::vector<Row>& rows) {
  const double resistance =
      LinearCell(dilute_strip(1, 1)).resistance() / (0.5 * strip_length * strip_width);
  const IonSolution steady = run_strip(dilute_strip(2.0 * resistance, 6.0 * resistance), options);
  Case input = dilute_strip(resistance, 3.0 * resistance);
  input.readout.scan.grounds_others = false;
  constexpr double instant = 1.0;
  const auto charge = [](const IonSolution& solution, std::size_t taxel) {
    return solution.top_segments[taxel].charge[row_at(solution, instant)];
  };
  std::array<std::vector<double>, 2> errors;
  for (const double dwell : {0.02, 0.01}) {
    input.readout.scan.dwell = dwell;
    const IonSolution scanned = run_strip(input, options);
    for (std::size_t taxel = 0; taxel < 2; ++taxel) {
      errors[taxel].push_back(std::abs(charge(scanned, taxel) - charge(steady, taxel)));
    }
  }
  for (std::size_t taxel = 0; taxel < 2; ++taxel) {
    const std::string name = taxel == 0 ? "first" : "second";
    rows.push_back(at_most("E10",
                           fmt::format("charge of the {} of two taxels scanned by 10 ms against "
                                       "twice the loads, relative",
                                       name),
                           errors[taxel][1] / std::abs(charge(steady, taxel)), 2e-3));
    rows.push_back(at_least("E10", fmt::format("order of the charge of the {} by the dwell", name),
                            std::log2(errors[taxel][0] / errors[taxel][1]), 0.9));
  }
}

} // namespace

std::vector<Row> taxel_rows(const Options& options) {
  std::vector<Row> rows;
  add_bridge_rows(options, rows);
  add_order_row(options, rows);
  add_limit_rows(options, rows);
  add_scan_rows(options, rows);
  add_conservation_rows(options, rows);
  add_reciprocity_row(options, rows);
  return rows;
}

} // namespace ionskin::verification
