// SPDX-License-Identifier: Apache-2.0
#include "poroelasticity/wet_cell.hpp"

#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"

#include <cmath>
#include <memory>
#include <utility>

namespace ionskin::verification {

Case wet_case() {
  Case input = model_case();
  input.coupling = {};
  input.coupling.law = "poroelastic";
  input.skin.layers[1].material.poissons_ratio = 0.49999999;
  input.water.drag_number = 2.5;
  input.water.drained_modulus = 3.9e8;
  input.water.mobility = 2e-19;
  return input;
}

Case proton_case() {
  Case input = wet_case();
  input.electrochemistry.temperature = 298.15;
  input.electrochemistry.diffusivity = 2.2e-9;
  input.water.drained_modulus = 2e8;
  input.water.mobility = 5e-17;
  input.water.dilution = WaterDilution::pore_water;
  input.water.volume_fraction = 1 / 2.6;
  return input;
}

double layer_factor(const Case& input) {
  const double a =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())
          .half_thickness;
  return 1 - std::tanh(a) / a;
}

history::CoreHistory held_pressure_history(double length, std::size_t columns,
                                           const std::function<double(double, double)>& pressure,
                                           std::vector<double> time) {
  const Case input = model_case();
  history::CoreHistory history;
  history.grid = {{}, {0.0, input.skin.width}, {}};
  for (std::size_t i = 0; i <= columns; ++i) {
    history.grid.x_edges.push_back(length * static_cast<double>(i) / static_cast<double>(columns));
  }
  history.measure = "prescribed";
  history.length = length;
  history.width = input.skin.width;
  history.time = std::move(time);
  history.event_time = {history.time.front()};
  constexpr std::size_t intervals = 8;
  history::StrainField field;
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double height = static_cast<double>(k) / intervals;
    history.grid.z_nodes.push_back(height * input.skin.core_thickness());
    for (std::size_t i = 0; i < columns; ++i) {
      field.push_back(
          pressure(0.5 * (history.grid.x_edges[i] + history.grid.x_edges[i + 1]), height));
    }
  }
  history.grid.z_nodes.back() = input.skin.core_thickness();
  history.add_channel(history::channel_name::undrained_pressure, "Pa")
      .samples.assign(history.time.size(), std::make_shared<const history::StrainField>(field));
  return history;
}

history::CoreHistory pressure_step_history(double bottom, double top, std::vector<double> time) {
  return held_pressure_history(
      model_case().skin.length, 1,
      [=](double, double height) { return bottom + (top - bottom) * height; }, std::move(time));
}

double final_voltage(Case input, double duration, const Options& options) {
  input.strain.duration = duration;
  return run_model(input, poroelasticity::prescribed_history(input), options).voltage.back();
}

} // namespace ionskin::verification
