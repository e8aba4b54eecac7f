// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace ionskin::verification {
namespace {

constexpr double youngs_modulus = 1.95e8; // undrained; with M = 390 MPa the drained ratio is 0.4
constexpr double drained_ratio = 0.4;

/// Case of a strip that is bent by 1/m at the first instant, with open terminals.
Case bent(SideCondition sides) {
  Case input = wet_case();
  input.skin.layers[1].material.youngs_modulus = youngs_modulus;
  input.skin.sides = sides;
  input.strain.kind = StrainSourceKind::prescribed;
  input.strain.curvature = 1;
  input.readout.circuit = "open";
  return input;
}

/// Voltage of a case before its water moves, once the double layers have relaxed [V].
double first_voltage(Case input, const Options& options) {
  input.water.mobility = 1e-40;
  return final_voltage(input, 1.0, options);
}

/// Pressure of a layer that is drained at one face, over the first pressure, at a height from its
/// sealed face.
double drained_profile(double height, double consolidation) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int n = 0; n < 400; ++n) {
    const double wave = (n + 0.5) * pi;
    sum += (n % 2 == 0 ? 2 : -2) / wave * std::cos(wave * height) *
           std::exp(-wave * wave * consolidation);
  }
  return sum;
}

/// Row on a pressed core whose top wall lets water through; the double layers see the pressure one
/// Debye length from the walls.
Row open_wall_row(const Options& options) {
  constexpr double consolidation = 0.2;
  Case input = bent(SideCondition::free);
  input.strain.curvature = 0;
  input.strain.pressure = small_pressure;
  input.water.top_wall = WaterWall::open;
  const auto water = poroelasticity::derive_water_properties(input);
  const double thickness = input.skin.core_thickness();
  const double depth =
      electrochemistry::derive_scales(input.electrochemistry, thickness).debye_length / thickness;
  const double difference =
      drained_profile(1 - depth, consolidation) - drained_profile(depth, consolidation);
  const double expected = -small_pressure * difference *
                          (water.streaming_coefficient -
                           water.dilution * water.thermal_voltage / water.drained_modulus);
  const double time = consolidation * thickness * thickness / water.consolidation_coefficient;
  return compare("P8", "open-circuit voltage of a pressed core with an open wall [V]",
                 final_voltage(input, time, options), expected, 2e-3 * std::abs(expected));
}

} // namespace

std::vector<Row> prescribed_load_rows(const Options& options) {
  std::vector<Row> rows;
  const auto add = [&rows](const std::string& quantity, double value, double expected) {
    rows.push_back(compare("P8", quantity, value, expected, 2e-3 * std::abs(expected)));
  };
  const Case narrow = bent(SideCondition::free), wide = bent(SideCondition::symmetry);
  const double thickness = narrow.skin.core_thickness(), layers = layer_factor(narrow);
  const auto water = poroelasticity::derive_water_properties(narrow);
  const double streaming = water.streaming_coefficient * youngs_modulus * thickness / 3 * layers;
  const double dilution =
      water.dilution * water.thermal_voltage * (1 - 2 * drained_ratio) * thickness * layers;
  add("open-circuit voltage of a narrow bent strip before water moves [V]",
      first_voltage(narrow, options), streaming);
  const double settled = 20 * water.consolidation_time(thickness);
  add("the same when the pressure is even [V]", final_voltage(narrow, settled, options), dilution);
  // 0.302118 of a linear pressure difference is left at c_v t/h2 = 0.1, all of it across the core:
  // the pressure is even near sealed walls, where a linear one falls within the double layers too.
  add("the same in between [V]",
      final_voltage(narrow, 0.1 * thickness * thickness / water.consolidation_coefficient, options),
      0.302118 * (streaming - dilution) / layers + dilution);
  add("open-circuit voltage of a wide bent plate before water moves [V]",
      first_voltage(wide, options), 2 * streaming);
  add("the same when the pressure is even [V]", final_voltage(wide, settled, options),
      dilution / (1 - drained_ratio));
  rows.push_back(open_wall_row(options));
  return rows;
}

} // namespace ionskin::verification
