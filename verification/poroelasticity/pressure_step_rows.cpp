// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Reference charge of a core: charge of the shorted top electrode after a step of 1 MPa in
/// proportion to z/h - 1/2, by the linear Poisson-Nernst-Planck equations with sealed walls (modes
/// through the thickness, computed apart from this program) [s], [C/m2].
struct Reference {
  std::string name;
  Case input;
  std::vector<std::pair<double, double>> charge;
};

std::vector<Reference> references() {
  constexpr double slow = 0.849317, water = 42.0873, fast = 0.0272532, moved = 0.328281;
  return {{"slow water",
           wet_case(),
           {{0.1 * slow, 0.0662422},
            {slow, 0.419447},
            {10 * slow, 0.521266},
            {water, 0.283157},
            {3 * water, 0.122483}}},
          {"wet protons",
           proton_case(),
           {{0.1 * fast, 0.0658952},
            {fast, 0.423511},
            {10 * fast, 0.575243},
            {moved, 0.563123},
            {3 * moved, 0.506513}}}};
}

IonSolution shorted(const Reference& reference, double refinement, const Options& options) {
  Case input = reference.input;
  input.numerics.mesh_refinement = refinement;
  // Where the mesh is refined, what the time steps leave must not stand before it.
  input.numerics.time_refinement = refinement > 1 ? 4 : 1;
  std::vector<double> time{0.0};
  for (const auto& [instant, charge] : reference.charge) {
    time.push_back(instant);
  }
  std::sort(time.begin(), time.end());
  return run_model(input, pressure_step_history(-0.5 * small_pressure, 0.5 * small_pressure, time),
                   options);
}

double charge(const IonSolution& solution, double time) {
  return per_megapascal * charge_difference(solution, row_at(solution, time)) / electrode_area;
}

/// Open-circuit voltage at a time after the step [V].
double open_voltage(Case input, double time, const Options& options) {
  input.readout.circuit = "open";
  const IonSolution solution = run_model(
      input, pressure_step_history(-0.5 * small_pressure, 0.5 * small_pressure, {0.0, time}),
      options);
  return per_megapascal * solution.voltage.back();
}

} // namespace

std::vector<Row> pressure_step_rows(const Options& options) {
  std::vector<Row> rows;
  for (const Reference& reference : references()) {
    Case still = reference.input;
    still.water.mobility = 1e-40;
    const auto water = poroelasticity::derive_water_properties(reference.input);
    const double streaming = -1e6 * water.streaming_coefficient * layer_factor(still);
    rows.push_back(
        compare("P3", "open-circuit voltage of 1 MPa before water moves [V], " + reference.name,
                open_voltage(still, 1.0, options), streaming, 2e-3 * std::abs(streaming)));
    const double diluted =
        -1e6 * water.dilution * water.thermal_voltage / water.drained_modulus * layer_factor(still);
    const double settled = 20 * water.consolidation_time(still.skin.core_thickness());
    rows.push_back(compare("P3", "the same when the pressure is even [V], " + reference.name,
                           open_voltage(reference.input, settled, options), diluted,
                           2e-3 * std::abs(diluted)));
    const IonSolution standard = shorted(reference, 1.0, options);
    for (const auto& [time, expected] : reference.charge) {
      rows.push_back(compare(
          "P4",
          fmt::format("charge of 1 MPa, shorted, at t = {:.4g} s [C/m2], {}", time, reference.name),
          charge(standard, time), expected, 2e-3 * expected));
    }
  }
  const Reference slow = references().front();
  const std::array runs{shorted(slow, 1.5, options), shorted(slow, 3.0, options),
                        shorted(slow, 6.0, options)};
  const auto change = [&](std::size_t i) {
    double sum = 0;
    for (const auto& [time, expected] : slow.charge) {
      sum += std::abs(charge(runs[i], time) - charge(runs[i + 1], time)) / expected;
    }
    return sum;
  };
  rows.push_back(at_least("P4", "observed order of the charge in space",
                          std::log2(change(0) / change(1)), 1.8));
  return rows;
}

} // namespace ionskin::verification
