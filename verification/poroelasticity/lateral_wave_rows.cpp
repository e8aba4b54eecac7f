// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace ionskin::verification {
namespace {

constexpr std::size_t columns = 48;

/// Amplitude of the top electrode's charge, proportional to cos(pi x/length), at a time after a
/// wave of undrained pressure of 1 MPa [C/m2]; the water does not move.
double charge_amplitude(bool odd, double time, const Options& options) {
  Case input = wet_case();
  const double length = 2 * input.skin.core_thickness();
  input.skin.length = length;
  input.water.mobility = 1e-40;
  const auto wave = [=](double x, double height) {
    return small_pressure * std::cos(std::numbers::pi * x / length) * (odd ? height - 0.5 : 1.0);
  };
  const auto solution =
      run_model(input, held_pressure_history(length, columns, wave, {0.0, time}), options);
  const auto& edges = solution.grid.x_edges;
  const std::size_t count = edges.size() - 1;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.5 * (edges[i] + edges[i + 1]);
    sum += 2 * std::cos(std::numbers::pi * x / length) * solution.column_charge_top[i];
  }
  return per_megapascal * sum / (length * input.skin.width);
}

} // namespace

// References: linear Poisson-Nernst-Planck equations of one lateral wave, computed by modes apart
// from this program.
std::vector<Row> lateral_wave_rows(const Options& options) {
  return {compare("P5", "charge of an odd wave of 1 MPa after its charging time [C/m2]",
                  charge_amplitude(true, 0.709165, options), 0.445858, 5e-3 * 0.445858),
          compare("P5", "charge of an even wave of 1 MPa after its charging time [C/m2]",
                  charge_amplitude(false, 1.64897, options), 0.896983, 5e-3 * 0.896983)};
}

} // namespace ionskin::verification
