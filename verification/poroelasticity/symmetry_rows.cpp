// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

const std::vector<double> instants{0.0, 0.01, 0.1, 1.0};

/// Solution under a pressure that is neither even nor odd through the thickness.
IonSolution pressed(const Case& input, double bottom, double top, const Options& options) {
  return run_model(input, pressure_step_history(bottom, top, instants), options);
}

double largest_charge(const IonSolution& solution) {
  double largest = 0;
  for (const double charge : solution.charge_top) {
    largest = std::max(largest, std::abs(charge));
  }
  return largest;
}

/// Solution under a uniform shear, with a dilation of 0 everywhere.
IonSolution sheared(const Options& options) {
  history::CoreHistory history = linear_step_history(0.05, 0.05, instants);
  history.add_channel(history::channel_name::dilation, "1")
      .samples.assign(history.time.size(),
                      std::make_shared<const history::StrainField>(history.grid.values(), 0.0));
  return run_model(wet_case(), history, options);
}

/// Deviation from antisymmetry under loads that are large enough for charges far above rounding.
double antisymmetry(const Options& options) {
  const IonSolution a = pressed(wet_case(), 1e6, 4e6, options);
  const IonSolution b = pressed(wet_case(), 4e6, 1e6, options);
  double worst = 0;
  for (const double time : instants) {
    const double qa = charge_difference(a, row_at(a, time)),
                 qb = charge_difference(b, row_at(b, time));
    worst = std::max(worst, std::abs(qa + qb));
  }
  return worst / largest_charge(a);
}

/// Deviation of a case whose water does not move from the law `pair-generation` on the dilation
/// with k = v L_s M_B/V_T, which has the same equation to first order.
double against_pair_generation(const Options& options) {
  Case wet = wet_case();
  wet.skin.layers[1].material.poissons_ratio = 0.49;
  wet.water.mobility = 1e-40;
  const auto water = poroelasticity::derive_water_properties(wet);
  const double dilation = 1e-4;
  history::CoreHistory history = linear_step_history(-0.5 * dilation, 0.5 * dilation, instants);
  history.channels.front().name = history::channel_name::dilation;
  const IonSolution moved = run_model(wet, history, options);
  Case pairs = model_case();
  pairs.coupling.law = "pair-generation";
  pairs.coupling.coefficient =
      water.streaming_coefficient * water.storage_modulus / water.thermal_voltage;
  const IonSolution released =
      run_model(pairs, linear_step_history(-0.5 * dilation, 0.5 * dilation, instants), options);
  double worst = 0;
  for (const double time : {0.1, 1.0}) {
    const double a = charge_difference(moved, row_at(moved, time));
    const double b = charge_difference(released, row_at(released, time));
    worst = std::max(worst, std::abs(a - b) / std::abs(b));
  }
  return worst;
}

double change_of_ions(const IonSolution& solution) {
  const auto [least, most] = std::ranges::minmax(solution.ion_amount);
  return (most - least) / solution.ion_amount.front();
}

} // namespace

std::vector<Row> symmetry_rows(const Options& options) {
  return {at_most("P6", "charge of a uniform shear [C]", largest_charge(sheared(options)), 0.0),
          at_most("P6", "charge of a mirrored load plus that of the load, relative",
                  antisymmetry(options), 1e-10),
          at_most("P6", "still water against pair-generation on the dilation, relative",
                  against_pair_generation(options), 1e-2),
          at_most("P7", "change of the ions in the core, relative",
                  change_of_ions(pressed(wet_case(), 1e4, 4e4, options)), 1e-14)};
}

} // namespace ionskin::verification
