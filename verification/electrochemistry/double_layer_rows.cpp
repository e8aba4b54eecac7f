// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ionskin::verification {
namespace {

constexpr double thermal_voltage = 25.2617e-3;

/// Charge of the top electrode over F c0 lambda after a ramp to `voltage` thermal voltages within
/// 0.5 s and a rest of many charging times.
double final_charge(double voltage, const Options& options) {
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.potentials.top = [voltage](double time) {
    return voltage * thermal_voltage * std::min(1.0, time / 0.5);
  };
  base::Timers timers;
  const auto solution = electrochemistry::solve_ion_transport(
      model_case(), linear_step_history(0.0, 0.0, {0.0, 0.5, 40.0}), ion_options, timers);
  return solution.charge_top.back() / (charge_density * electrode_area);
}

} // namespace

std::vector<Row> double_layer_rows(const Options& options) {
  std::vector<Row> rows;
  for (const auto& [voltage, charge] :
       {std::pair{1.0, 0.496592}, std::pair{5.0, 2.198963}, std::pair{20.0, 5.657609}}) {
    rows.push_back(compare("E5", fmt::format("wall charge / q0 at {} thermal voltages", voltage),
                           final_charge(voltage, options), charge, 2e-3 * charge));
  }
  return rows;
}

} // namespace ionskin::verification
